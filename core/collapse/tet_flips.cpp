// Edge and triangle removal, and which ones a collapse asks for.
#include "collapse/tet_flips.h"

#include "criteria/link.h"
#include "mesh/predicates.h"

#include <algorithm>
#include <utility>

namespace isoscope {

namespace {

using LocalTet = TetPatch::LocalTet;

constexpr std::size_t most_in_ring = 8;
constexpr int most_flips = 6; ///< for one collapse

bool positive(const TetPatch& patch, const LocalTet& t) {
  return orientation(patch.point(t.v[0]), patch.point(t.v[1]), patch.point(t.v[2]), patch.point(t.v[3])) > 0;
}

/// The corners of a tetrahedron other than p and q, such that (p, q, first, second) is positively oriented.
std::array<std::uint32_t, 2> opposite_edge(const LocalTet& t, std::uint32_t p, std::uint32_t q) {
  std::array<std::uint32_t, 4> v = t.v;
  bool odd = false;
  const auto bring = [&](std::size_t to, std::uint32_t vertex) {
    if (v[to] == vertex) return;
    std::iter_swap(v.begin() + static_cast<std::ptrdiff_t>(to), std::find(v.begin(), v.end(), vertex));
    odd = !odd;
  };
  bring(0, p);
  bring(1, q);
  if (odd) std::swap(v[2], v[3]);
  return {v[2], v[3]};
}

/// The vertices around pq in order; empty when the tetrahedra at it do not close up on one side of Z.
std::vector<std::uint32_t> ring_of(const TetPatch& patch, std::span<const std::uint32_t> tets,
                                   std::uint32_t p, std::uint32_t q) {
  std::vector<std::array<std::uint32_t, 2>> steps;
  for (const std::uint32_t t : tets) {
    if (patch.tet(t).side != patch.tet(tets[0]).side) return {};
    steps.push_back(opposite_edge(patch.tet(t), p, q));
  }
  std::sort(steps.begin(), steps.end());
  std::vector<std::uint32_t> ring{steps.front()[0]};
  while (ring.size() <= steps.size()) {
    const auto next = std::lower_bound(steps.begin(), steps.end(), std::array{ring.back(), 0u});
    if (next == steps.end() || (*next)[0] != ring.back()) return {};
    if ((*next)[1] == ring.front()) break;
    ring.push_back((*next)[1]);
  }
  return ring.size() == steps.size() ? ring : std::vector<std::uint32_t>{};
}

/// Triangulates the ring from i to j so that the tetrahedra over and under each triangle are positive.
bool fill(const TetPatch& patch, std::span<const std::uint32_t> ring, std::size_t i, std::size_t j,
          const std::array<std::uint32_t, 2>& apexes, std::vector<LocalTet>& tets) {
  if (j == i + 1) return true;
  const std::size_t kept = tets.size();
  for (std::size_t k = i + 1; k < j; ++k) {
    const LocalTet over{{ring[i], ring[k], ring[j], apexes[1]}};
    const LocalTet under{{ring[i], ring[j], ring[k], apexes[0]}};
    if (!positive(patch, over) || !positive(patch, under)) continue;
    tets.push_back(over);
    tets.push_back(under);
    if (fill(patch, ring, i, k, apexes, tets) && fill(patch, ring, k, j, apexes, tets)) return true;
    tets.resize(kept);
  }
  return false;
}

/// Removes what makes the link condition of T fail; false when nothing that helps was found.
bool mend_link(TetPatch& patch, const EdgeStar& star) {
  const LinkVerdict link = check_link(star, true);
  const std::array ends{patch.local(star.a()), patch.local(star.b())};
  for (const auto& simplex : link.offending_t)
    for (const std::uint32_t end : ends) {
      if (simplex.size() == 1 && remove_edge(patch, end, patch.local(simplex[0]))) return true;
      if (simplex.size() == 2 &&
          remove_triangle(patch, {end, patch.local(simplex[0]), patch.local(simplex[1])}))
        return true;
    }
  return false;
}

/// Removes an edge from an end to a facet that bounds the empty kernel, the one that leaves it least empty;
/// false when none makes it less so.
bool widen_kernel(TetPatch& patch, const EdgeStar& star, const Kernel& kernel) {
  std::vector<VertexId> corners;
  std::vector<const EdgeStar::StarTet*> outer;
  for (const EdgeStar::StarTet& t : star.tets)
    if (!t.ring()) outer.push_back(&t);
  for (const std::uint32_t w : kernel.witness)
    for (const std::uint16_t v : outer[w]->v)
      if (v > 1) corners.push_back(star.vertices[v].id);
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::optional<TetPatch> best;
  double least = kernel.missing_slack;
  for (const VertexId corner : corners)
    for (const VertexId end : {star.a(), star.b()}) {
      TetPatch trial = patch;
      if (!remove_edge(trial, trial.local(end), trial.local(corner))) continue;
      const EdgeStar after = trial.star(star.a(), star.b());
      if (!check_link(after, false).holds()) continue;
      const Kernel found = compute_kernel(after);
      const double missing = found.empty ? found.missing_slack : -found.inscribed_radius;
      if (missing >= least) continue;
      least = missing;
      best = std::move(trial);
    }
  if (best) patch = std::move(*best);
  return best.has_value();
}

} // namespace

bool remove_edge(TetPatch& patch, std::uint32_t p, std::uint32_t q) {
  std::vector<std::uint32_t> around;
  for (const std::uint32_t t : patch.tets_at(p))
    if (patch.tet(t).has(q)) around.push_back(t);
  if (around.size() < 3 || around.size() > most_in_ring) return false;
  const std::vector<std::uint32_t> ring = ring_of(patch, around, p, q);
  std::vector<LocalTet> tets;
  if (ring.empty() || !fill(patch, ring, 0, ring.size() - 1, {p, q}, tets)) return false;
  for (LocalTet& t : tets) t.side = patch.tet(around[0]).side;
  patch.replace(around, tets);
  return true;
}

bool remove_triangle(TetPatch& patch, const std::array<std::uint32_t, 3>& triangle) {
  std::vector<std::uint32_t> sides;
  for (const std::uint32_t t : patch.tets_at(triangle[0]))
    if (patch.tet(t).has(triangle[1]) && patch.tet(t).has(triangle[2])) sides.push_back(t);
  if (sides.size() != 2 || patch.tet(sides[0]).side != patch.tet(sides[1]).side) return false;
  std::array<std::uint32_t, 2> apex{};
  for (std::size_t i = 0; i < 2; ++i)
    for (const std::uint32_t v : patch.tet(sides[i]).v)
      if (std::find(triangle.begin(), triangle.end(), v) == triangle.end()) apex[i] = v;
  // Counter-clockwise seen from the first apex.
  const auto [x, y] = opposite_edge(patch.tet(sides[0]), triangle[0], apex[0]);
  const std::array<std::uint32_t, 3> ring{triangle[0], x, y};
  std::array<LocalTet, 3> tets;
  for (std::size_t k = 0; k < 3; ++k) {
    tets[k] = {{ring[k], ring[(k + 1) % 3], apex[1], apex[0]}, patch.tet(sides[0]).side};
    if (!positive(patch, tets[k])) return false;
  }
  patch.replace(sides, tets);
  return true;
}

Refusal make_collapsible(TetPatch& patch, VertexId a, VertexId b, Kernel& kernel) {
  for (int flips = 0;; ++flips) {
    const EdgeStar star = patch.star(a, b);
    const LinkVerdict link = check_link(star, false);
    if (!link.holds_in_t) {
      if (flips < most_flips && mend_link(patch, star)) continue;
      return {Reason::link_condition, 0, 0, {}};
    }
    if (!link.holds_in_strata()) return {Reason::zero_link_condition, 0, 0, {}};
    kernel = compute_kernel(star);
    if (!kernel.empty) return {};
    if (flips >= most_flips || !widen_kernel(patch, star, kernel))
      return {Reason::kernel_empty, kernel.inscribed_radius, 0, kernel.center};
  }
}

} // namespace isoscope
