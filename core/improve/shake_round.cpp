// Batches of forced flips.
#include "improve/shake_round.h"

#include "base/parallel.h"
#include "base/scramble.h"

#include <algorithm>
#include <deque>

namespace isoscope {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::deque<Edge> edges_in_order(const FacetComplex& complex, std::uint32_t pass) {
  std::vector<std::pair<std::uint64_t, Edge>> keyed;
  for (const Edge& e : complex.edges())
    keyed.emplace_back(scrambled((std::uint64_t{e.first} << 32 | e.second) + golden_step * (pass + 1u)), e);
  std::sort(keyed.begin(), keyed.end());
  std::deque<Edge> edges;
  for (const auto& [key, edge] : keyed) edges.push_back(edge);
  return edges;
}

struct FlipAttempt {
  Edge edge;
  SurfacePatch patch;
  std::optional<PatchVerdict> verdict;
  std::optional<FlipsInVain::Outcome> known; ///< it has failed before, on the same facets
};

/// Tries that are made side by side, wherever they are: few of those that would do come too late.
constexpr std::size_t flips_at_once = 8;

/// What is known of a flip that failed when the facets of its patch, and those next to them, were the same.
std::optional<FlipsInVain::Outcome> outcome_before(const LiveSurface& surface, const Edge& edge, int rings,
                                                   const FlipsInVain::Memory* memory) {
  const auto* known = memory != nullptr ? memory->find(edge.first, edge.second) : nullptr;
  if (known == nullptr) return std::nullopt;
  for (const std::uint32_t v : vertices_around(surface.complex(), {edge.first, edge.second}, rings + 1))
    if (surface.stamp(v) > known->time) return std::nullopt;
  return known->value;
}

/// Takes edges from the front that may be flipped.
std::vector<FlipAttempt> gather(const LiveSurface& surface, const SurfaceRules& rules,
                                const ShakeOptions& options, const FlipsInVain::Memory* memory,
                                std::deque<Edge>& edges) {
  std::vector<FlipAttempt> attempts;
  while (!edges.empty() && attempts.size() < flips_at_once) {
    const auto [a, b] = edges.front();
    edges.pop_front();
    if (surface.frozen(a) || surface.frozen(b) ||
        !is_worth_a_flip(rules, surface.complex(), a, b, options.repair))
      continue;
    FlipAttempt attempt{{a, b}, {}, {}, outcome_before(surface, {a, b}, options.rings, memory)};
    if (!attempt.known)
      attempt.patch = surface.patch(vertices_around(surface.complex(), {a, b}, options.rings));
    attempts.push_back(std::move(attempt));
  }
  return attempts;
}

} // namespace

ShakeFigures shake(LiveSurface& surface, const SurfaceRules& rules, const ShakeOptions& options,
                   const RunControl& control) {
  ShakeFigures figures;
  std::deque<Edge> edges = edges_in_order(surface.complex(), options.pass);
  FlipsInVain::Memory* memory = options.in_vain != nullptr && surface.stamps_tell_all()
                                    ? &options.in_vain->of(options.repair, options.rings)
                                    : nullptr;
  while (!edges.empty() && figures.attempts < options.most_attempts && !control.cancelled()) {
    std::vector<FlipAttempt> attempts = gather(surface, rules, options, memory, edges);
    const std::uint32_t now = surface.commits();
    const bool complete = parallel_until(attempts.size(), 1, control, [&](std::size_t i) {
      FlipAttempt& a = attempts[i];
      if (a.known) return;
      a.verdict = flip_with_repair(rules, a.patch, a.patch.local_vertex(a.edge.first),
                                   a.patch.local_vertex(a.edge.second), options.repair);
    });
    if (!complete) break;
    std::vector<Edge> too_late;
    for (const FlipAttempt& a : attempts) {
      if (a.known) {
        figures.attempts += a.known->tried ? 1 : 0;
        continue;
      }
      if (memory != nullptr && !(a.verdict && a.verdict->accepted()))
        memory->set(a.edge.first, a.edge.second, {now, {a.verdict.has_value()}});
      if (!a.verdict) continue;
      ++figures.attempts;
      if (!a.verdict->accepted()) continue;
      if (!surface.up_to_date(a.patch)) {
        too_late.push_back(a.edge);
        continue;
      }
      if (!surface.check(a.patch).accepted()) continue;
      // What failed by much is not worth another try after this.
      surface.commit(a.patch, EventKind::relaxation);
      ++figures.flipped;
      figures.largest = std::max(figures.largest, a.patch.largest_distance(rules.input->delta()));
    }
    edges.insert(edges.begin(), too_late.begin(), too_late.end());
  }
  figures.all_tried = edges.empty();
  return figures;
}

} // namespace isoscope
