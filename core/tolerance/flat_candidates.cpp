// A plane is told by its triangles, and points on its offset need no search.
#include "tolerance/flat_candidates.h"

#include "base/snap.h"
#include "tolerance/closest_point.h"
#include "tolerance/rounding.h"

#include <cmath>
#include <optional>

namespace isoscope {
namespace {

/// How far triangles may leave their plane, relative to δ'.
constexpr double most_unevenness = 0.1;
/// Nearer to the input the direction away from it means little, relative to δ'.
constexpr double least_height = 1e-3;

} // namespace

bool FlatCandidates::add(const CandidateCube& cell, std::vector<SampleCandidate>& candidates) {
  const auto& [center, side, closest] = cell;
  const double d = closest.distance(), reach = half_diagonal * side, slack = most_unevenness * boundary_;
  // What is nearest to any point of the cell, and to one as far out as half its diagonal, is within that.
  const double radius = d + 2 * reach;
  if (!(d > least_height * boundary_) ||
      !volume_.index().coplanar_within(center, radius, closest.triangle, slack))
    return false;
  const Vec3 up = (center - closest.point) / d;
  const double extent = 0.5 * side * (std::abs(up.x) + std::abs(up.y) + std::abs(up.z));
  if (std::abs(d - boundary_) > extent + slack) return true;

  // Seen from outside the closest point leads to ∂Ω'.
  const Vec3 outer = closest.point + (d + reach) * up;
  const ClosestPoint of_outer{closest.point, (d + reach) * (d + reach), closest.triangle};
  const bool inside = d < boundary_;
  const ClosestPoint below = inside ? volume_.field().closest_near(outer, closest.triangle) : closest;
  const std::optional<Vec3> q = volume_.field().at_level(inside ? outer : center, below, boundary_);
  if (!q) return false;
  SampleCandidate candidate;
  candidate.center = center;
  candidate.half_side = 0.5 * side;
  candidate.point = snapped(*q, options_.snap_unit);
  if (farthest_in_cube(candidate.point, center, candidate.half_side) > options_.target_bound) return false;
  candidate.volume_component = volume_.volume_component(below.triangle);
  candidate.region = region_around(outer, d + reach - slack - boundary_, inside ? below : of_outer);
  if (!candidate.region.valid()) return false;
  candidate.label = static_cast<std::int8_t>(volume_.regions()[candidate.region.index()].label);
  candidate.has_point = true;
  candidates.push_back(candidate);
  return true;
}

RegionId FlatCandidates::region_around(Vec3 center, double radius, const ClosestPoint& closest) {
  const bool known =
      known_region_.valid() && distance(center, known_center_) < (radius + known_radius_) * (1 - 1e-9);
  if (!known) known_region_ = volume_.escape(center, closest).region;
  known_center_ = center;
  known_radius_ = radius;
  return known_region_;
}

} // namespace isoscope
