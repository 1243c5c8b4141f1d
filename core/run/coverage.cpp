// Facet certificates decide; where they fail, pieces of the input beyond the limit are grouped by a grid.
#include "run/coverage.h"

#include "base/disjoint_sets.h"
#include "base/halves.h"
#include "base/parallel.h"
#include "run/lattice_cell.h"
#include "run/proof_budget.h"
#include "tolerance/facet_certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace isoscope {
namespace {

constexpr std::size_t cover_grain = 64;
/// Pieces beyond the limit are cut no finer than makes about so many of them.
constexpr double most_pieces = 50000;
/// And no triangle into more.
constexpr std::size_t most_pieces_each = 400000;

/// A piece of an input triangle whose centroid is beyond the limit.
struct Piece {
  Triangle3 corners;
  Vec3 center;
  double distance = 0;
};

/// The pieces of a triangle, of at most `radius`, whose centroids are beyond the limit.
std::vector<Piece> pieces_beyond(const ClosestPointIndex& mesh, const Triangle3& triangle, double limit,
                                 double radius) {
  std::vector<Piece> beyond;
  std::vector<Triangle3> open{triangle};
  for (std::size_t looked = 0; !open.empty() && looked < most_pieces_each; ++looked) {
    const Triangle3 t = open.back();
    open.pop_back();
    const Vec3 center = centroid(t);
    const double d = mesh.distance(center);
    double r = 0;
    for (const Vec3 p : t) r = std::max(r, distance(p, center));
    if (d + r <= limit) continue;
    if (r <= radius) {
      if (d > limit) beyond.push_back({t, center, d});
      continue;
    }
    for (const Triangle3& half : halves(t)) open.push_back(half);
  }
  return beyond;
}

/// Joins pieces whose centroids lie in the same cell of a grid or in neighbouring ones.
DisjointSets group(const std::vector<Piece>& pieces, Vec3 origin, double side) {
  std::vector<std::pair<LatticeCell, std::uint32_t>> by_cell;
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    by_cell.emplace_back(lattice_cell(pieces[i].center, origin, side), i);
  std::sort(by_cell.begin(), by_cell.end());
  DisjointSets sets(pieces.size());
  for (std::size_t i = 0; i < by_cell.size(); ++i) {
    if (i > 0 && by_cell[i].first == by_cell[i - 1].first) {
      sets.unite(by_cell[i].second, by_cell[i - 1].second);
      continue;
    }
    for (int k = 0; k < 27; ++k) {
      LatticeCell next = by_cell[i].first;
      next[0] += k % 3 - 1, next[1] += k / 3 % 3 - 1, next[2] += k / 9 - 1;
      const auto found = std::lower_bound(by_cell.begin(), by_cell.end(), std::pair(next, std::uint32_t{0}));
      if (found != by_cell.end() && found->first == next) sets.unite(by_cell[i].second, found->second);
    }
  }
  return sets;
}

void collect_places(const std::vector<Piece>& pieces, const ClosestPointIndex& mesh, Vec3 origin, double side,
                    Coverage& coverage) {
  DisjointSets sets = group(pieces, origin, side);
  std::vector<std::uint32_t> order(pieces.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return sets.find(a) < sets.find(b); });
  for (std::size_t i = 0; i < order.size();) {
    const std::uint32_t root = sets.find(order[i]);
    UncoveredPlace place;
    Box3 box;
    const Piece* farthest = nullptr;
    for (; i < order.size() && sets.find(order[i]) == root; ++i) {
      const Piece& piece = pieces[order[i]];
      for (const Vec3 p : piece.corners) box.add(p);
      if (farthest == nullptr || piece.distance > farthest->distance) farthest = &piece;
    }
    place = {farthest->center, farthest->distance, box.longest_edge()};
    for (const Vec3 p : farthest->corners)
      if (const double d = mesh.distance(p); d > place.distance) place.point = p, place.distance = d;
    coverage.places.push_back(place);
  }
  std::stable_sort(coverage.places.begin(), coverage.places.end(),
                   [](const auto& a, const auto& b) { return a.distance > b.distance; });
  coverage.count = coverage.places.size();
  if (coverage.places.size() > most_uncovered_places) coverage.places.resize(most_uncovered_places);
}

} // namespace

Coverage judge_coverage(const ClosestPointIndex& input, const ClosestPointIndex& mesh,
                        const DistanceBounds& bounds, double limit, double resolution,
                        const RunControl& control) {
  Coverage coverage;
  if (bounds.upper <= limit) {
    coverage.verdict = Coverage::Verdict::covered;
    return coverage;
  }
  struct Beyond {
    TriangleId triangle;
    FacetVerdict verdict;
  };
  std::vector<Beyond> beyond;
  bool undecided = false;
  double surface = 0;
  std::vector<FacetVerdict> verdicts;
  for (std::size_t first = 0; first < input.size(); first += verdicts.size()) {
    verdicts.assign(std::min(verdicts_at_once, input.size() - first), {});
    parallel_for(verdicts.size(), cover_grain, [&](std::size_t i) {
      if (control.out_of_grace()) return;
      verdicts[i] = certify_facet(mesh, input.triangle(TriangleId(first + i)), limit, limit, proof_budget);
    });
    if (control.out_of_grace()) return coverage;
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      undecided = undecided || verdicts[i].kind == FacetVerdict::Kind::undecided;
      if (verdicts[i].kind != FacetVerdict::Kind::outside) continue;
      beyond.push_back({TriangleId(first + i), verdicts[i]});
      surface += area(input.triangle(TriangleId(first + i)));
    }
  }
  if (beyond.empty()) {
    coverage.verdict = undecided ? Coverage::Verdict::undecided : Coverage::Verdict::covered;
    return coverage;
  }
  coverage.verdict = Coverage::Verdict::uncovered;
  const double radius = std::max(0.5 * resolution, std::sqrt(surface / most_pieces));
  std::vector<std::vector<Piece>> of_triangle(beyond.size());
  parallel_for(beyond.size(), 1, [&](std::size_t i) {
    if (control.out_of_grace()) return;
    const Triangle3 t = input.triangle(beyond[i].triangle);
    of_triangle[i] = pieces_beyond(mesh, t, limit, radius);
    // What is beyond the limit may be smaller than a piece.
    const FacetVerdict& v = beyond[i].verdict;
    if (of_triangle[i].empty())
      of_triangle[i].push_back({{v.witness, v.witness, v.witness}, v.witness, v.closest.distance()});
  });
  std::vector<Piece> pieces;
  for (const auto& list : of_triangle) pieces.insert(pieces.end(), list.begin(), list.end());
  if (!pieces.empty()) collect_places(pieces, mesh, input.bounds().lo, 2 * radius, coverage);
  return coverage;
}

} // namespace isoscope
