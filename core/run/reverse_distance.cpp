// Rounds of facet certificates: each proves most triangles to be near, and finds farther points on the
// others.
#include "run/reverse_distance.h"

#include "base/parallel.h"
#include "run/proof_budget.h"
#include "tolerance/facet_certificate.h"
#include "tolerance/rounding.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

namespace {

constexpr std::size_t grain = 256;
/// A computed distance comes from fewer.
constexpr int roundings = 32;

/// The farthest point found so far: what a triangle must exceed to count.
struct Farthest {
  Vec3 point;
  double distance = 0;
  void add(Vec3 p, double d) {
    if (d > distance) *this = {p, d};
  }
};

Farthest farthest_corner(const ClosestPointIndex& from, const ClosestPointIndex& to,
                         const std::function<bool()>& stop) {
  // The first corners meet nearly every vertex once; a vertex that they miss is met by its facet's
  // certificate.
  std::vector<double> distances(from.size());
  parallel_until(from.size(), grain, stop, [&](std::size_t i) {
    distances[i] = to.distance(from.triangle(TriangleId(static_cast<std::uint32_t>(i)))[0]);
  });
  Farthest farthest;
  for (std::size_t i = 0; i < distances.size(); ++i)
    farthest.add(from.triangle(TriangleId(static_cast<std::uint32_t>(i)))[0], distances[i]);
  return farthest;
}

/// What the distance of an undecided triangle's points cannot exceed, since distances are 1-Lipschitz.
double crude_bound(const ClosestPointIndex& to, const Triangle3& t) {
  return to.distance(t[0]) + std::max(length(t[1] - t[0]), length(t[2] - t[0]));
}

} // namespace

DistanceBounds bound_distance(const ClosestPointIndex& from, const ClosestPointIndex& to, double precision,
                              const RunControl& control) {
  if (from.empty()) return {0, 0, {}};
  if (to.empty()) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {infinity, infinity, from.triangle(TriangleId(0))[0]};
  }
  const std::function<bool()> stop = [&control] { return control.out_of_grace(); };
  Farthest farthest = farthest_corner(from, to, stop);
  std::vector<std::uint32_t> open(from.size());
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = static_cast<std::uint32_t>(i);

  double upper = 0;
  std::vector<FacetVerdict> verdicts;
  while (!open.empty()) {
    if (stop()) return {};
    // A triangle that stays open has a point beyond the lower bound by half the precision: the bound grows by
    // that much in every round, so that rounds end. Fixed limits keep a round independent of its order.
    const double reject = farthest.distance + 0.5 * precision, accept = farthest.distance + precision;
    const FacetSearch search{proof_budget, {}, nullptr, 0, &stop};
    std::size_t still_open = 0;
    for (std::size_t first = 0; first < open.size(); first += verdicts.size()) {
      verdicts.assign(std::min(verdicts_at_once, open.size() - first), {});
      const bool complete = parallel_until(verdicts.size(), grain, stop, [&](std::size_t i) {
        const Triangle3& t = from.triangle(TriangleId(open[first + i]));
        verdicts[i] = certify_facet(to, t, accept, reject, search);
      });
      if (!complete || stop()) return {};
      for (std::size_t i = 0; i < verdicts.size(); ++i) {
        const FacetVerdict& v = verdicts[i];
        const std::uint32_t id = open[first + i];
        if (v.kind == FacetVerdict::Kind::inside) {
          upper = std::max(upper, v.max_distance);
        } else if (v.kind == FacetVerdict::Kind::outside) {
          farthest.add(v.witness, v.closest.distance());
          open[still_open++] = id;
        } else {
          upper = std::max(upper, crude_bound(to, from.triangle(TriangleId(id))));
        }
      }
    }
    open.resize(still_open);
  }
  const double rounding = rounding_bound(from.bounds(), to.bounds(), roundings);
  return {std::max(0.0, farthest.distance - rounding), upper + rounding, farthest.point};
}

} // namespace isoscope
