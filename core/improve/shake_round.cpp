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
};

/// Tries that are made side by side, wherever they are: few of those that would do come too late.
constexpr std::size_t flips_at_once = 8;

/// Takes edges from the front that may be flipped.
std::vector<FlipAttempt> gather(const LiveSurface& surface, const SurfaceRules& rules,
                                const ShakeOptions& options, std::deque<Edge>& edges) {
  std::vector<FlipAttempt> attempts;
  while (!edges.empty() && attempts.size() < flips_at_once) {
    const auto [a, b] = edges.front();
    edges.pop_front();
    if (surface.frozen(a) || surface.frozen(b) ||
        !is_worth_a_flip(rules, surface.complex(), a, b, options.repair))
      continue;
    attempts.push_back(
        {{a, b}, surface.patch(vertices_around(surface.complex(), {a, b}, options.rings)), {}});
  }
  return attempts;
}

} // namespace

ShakeFigures shake(LiveSurface& surface, const SurfaceRules& rules, const ShakeOptions& options,
                   const RunControl& control) {
  ShakeFigures figures;
  std::deque<Edge> edges = edges_in_order(surface.complex(), options.pass);
  while (!edges.empty() && figures.attempts < options.most_attempts && !control.cancelled()) {
    std::vector<FlipAttempt> attempts = gather(surface, rules, options, edges);
    const bool complete = parallel_until(attempts.size(), 1, control, [&](std::size_t i) {
      FlipAttempt& a = attempts[i];
      a.verdict = flip_with_repair(rules, a.patch, a.patch.local_vertex(a.edge.first),
                                   a.patch.local_vertex(a.edge.second), options.repair);
    });
    if (!complete) break;
    std::vector<Edge> too_late;
    for (const FlipAttempt& a : attempts) {
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
