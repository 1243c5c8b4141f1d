// Batches of forced flips.
#include "improve/shake_round.h"

#include "base/parallel.h"
#include "base/scramble.h"
#include "improve/patch_claims.h"

#include <algorithm>
#include <deque>

namespace isoscope {
namespace {

/// Free vertices of a flip: this many edges from its ends.
constexpr int rings = 1;

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

/// Takes edges from the front whose patches are apart; those that overlap go back in their order.
std::vector<FlipAttempt> gather(const LiveSurface& surface, std::deque<Edge>& edges, PatchClaims& claims) {
  const std::size_t size = std::clamp<std::size_t>(surface.vertex_count() / 16, 1, most_batch);
  std::vector<FlipAttempt> attempts;
  std::vector<Edge> aside;
  claims.begin_batch();
  for (std::size_t looked = 0; looked < most_looked_at && !edges.empty() && attempts.size() < size;
       ++looked) {
    const Edge e = edges.front();
    edges.pop_front();
    if (surface.frozen(e.first) || surface.frozen(e.second)) continue;
    if (!surface.complex().has_edge(e.first, e.second)) continue;
    if (auto patch = claims.take(surface, e.first, e.second, rings)) {
      attempts.push_back({e, std::move(*patch), {}});
    } else {
      aside.push_back(e);
    }
  }
  edges.insert(edges.begin(), aside.begin(), aside.end());
  return attempts;
}

} // namespace

ShakeFigures shake(LiveSurface& surface, const SurfaceRules& rules, const ShakeOptions& options,
                   const RunControl& control) {
  ShakeFigures figures;
  std::deque<Edge> edges = edges_in_order(surface.complex(), options.pass);
  PatchClaims claims(surface.complex().points.size());
  while (!edges.empty() && figures.attempts < options.most_attempts && !control.cancelled()) {
    std::vector<FlipAttempt> attempts = gather(surface, edges, claims);
    parallel_until(attempts.size(), 1, control, [&](std::size_t i) {
      FlipAttempt& a = attempts[i];
      a.verdict = flip_with_repair(rules, a.patch, a.patch.local_vertex(a.edge.first),
                                   a.patch.local_vertex(a.edge.second), options.repair);
    });
    for (const FlipAttempt& a : attempts) {
      if (!a.verdict) continue;
      ++figures.attempts;
      if (!a.verdict->accepted() || !surface.check(a.patch).accepted()) continue;
      // What failed by much is not worth another try after this.
      surface.commit(a.patch, EventKind::relaxation);
      ++figures.flipped;
      figures.largest = std::max(figures.largest, a.patch.largest_distance(rules.input->delta()));
    }
  }
  return figures;
}

} // namespace isoscope
