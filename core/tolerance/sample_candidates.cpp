// Subdivides a cell until a boundary point close enough to all of each part is known.
#include "tolerance/sample_candidates.h"

#include "base/snap.h"
#include "tolerance/rounding.h"

#include <cmath>
#include <optional>

namespace isoscope {
namespace {

/// The side of the coarsest candidates, relative to the density. A third would save up to a third of the
/// samples, but takes up to twice the time.
constexpr double coarsest_cell = 0.5;
/// Where to ask for the region behind a boundary point, relative to δ'.
constexpr double step_out = 1.06;
/// How far from δ' a projected point may be, relative to δ'.
constexpr double projection_error = 1e-11;

Vec3 corner(unsigned k, double q) {
  return {k & 1u ? q : -q, k & 2u ? q : -q, k & 4u ? q : -q};
}

/// Whether a point at most `reach` away from one of distance d may be on ∂Ω'.
bool may_hold_boundary(double d, double reach, double boundary) {
  return d <= boundary + reach && d + reach >= boundary;
}

class Subdivision {
 public:
  Subdivision(const ToleranceVolume& volume, const CandidateOptions& options,
              std::vector<SampleCandidate>& out)
      : volume_(volume), options_(options), boundary_(volume.thresholds().boundary), out_(out) {}

  /// Splits a cube, whose side is about the density, evenly into cells small enough to be covered by few
  /// samples.
  void visit_cube(const CandidateCube& cube) {
    const auto& [center, side, closest] = cube;
    const double d = closest.distance(), reach = half_diagonal * side;
    // Enough for the cells' centres, at most two thirds of the reach away, and for points of ∂Ω'.
    volume_.field().find_neighborhood(
        center, std::max(d + 1.35 * reach, (2 * step_out - 1) * boundary_ + reach), near_);
    const double cells = std::ceil(side / (coarsest_cell * options_.target_bound)), cell = side / cells;
    const int n = static_cast<int>(cells);
    for (int z = 0; z < n; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
          const Vec3 offset = Vec3{x + 0.5 - 0.5 * n, y + 0.5 - 0.5 * n, z + 0.5 - 0.5 * n} * cell;
          if (may_hold_boundary(d, length(offset) + half_diagonal * cell, boundary_))
            visit(center + offset, cell, closest.triangle);
        }
  }

 private:
  void visit(Vec3 center, double side, TriangleId guess) {
    const double reach = half_diagonal * side;
    const ClosestPoint closest = volume_.field().closest_near(center, guess, near_, boundary_ - reach);
    if (!may_hold_boundary(closest.distance(), reach, boundary_)) return;

    SampleCandidate candidate;
    candidate.center = center;
    candidate.half_side = 0.5 * side;
    bool last = 0.5 * side < options_.smallest_side;
    if (project(candidate, closest, last)) {
      find_side(candidate, closest);
      last = last || 0.5 * side < options_.crevice_side;
    }
    if (candidate.has_point || last) {
      out_.push_back(candidate);
      return;
    }
    for (unsigned k = 0; k < 8; ++k) visit(center + corner(k, 0.25 * side), 0.5 * side, closest.triangle);
  }

  /// Finds a point at δ' near the centre, if it covers the cell. Where φ is a distance it lies on the ray
  /// from the closest point through the centre: seen from outside it is exact; from inside another site may
  /// be nearer there, which one more query tells.
  bool project(SampleCandidate& candidate, const ClosestPoint& closest, bool last) const {
    const double d = closest.distance();
    if (!(d > 1e-6 * boundary_)) return false;
    const std::optional<Vec3> q = volume_.field().at_level(candidate.center, closest, boundary_);
    if (!q) return false;
    candidate.point = snapped(*q, options_.snap_unit);
    const double bound = farthest_in_cube(candidate.point, candidate.center, candidate.half_side);
    if (bound > options_.target_bound && !last) return false;
    if (d >= boundary_ || !volume_.field().is_distance()) return true;
    const double least = boundary_ * (1 - projection_error);
    return volume_.field().closest_near(*q, closest.triangle, near_, least).distance() >= least;
  }

  void find_side(SampleCandidate& candidate, const ClosestPoint& closest) {
    if (!volume_.field().is_distance()) return find_side_from_the_point(candidate, closest.triangle);
    candidate.volume_component = volume_.volume_component(closest.triangle);
    if (volume_.open_sides() != nullptr && volume_.open_sides()->is_open(closest.triangle)) {
      // On the way to the boundary point the closest point stays what it is.
      const ClosestPoint own{closest.point, squared_length(candidate.point - closest.point),
                             closest.triangle};
      set_label(candidate, volume_.open_sides()->side(candidate.point, own));
      candidate.region = volume_.escape(candidate.point, own).region;
      known_region_ = {};
      return;
    }
    if (!known_region_.valid() || !(options_.one_region_a_cell || meets_known_ball(candidate, closest))) {
      // From outside the way to the boundary point is straight, so the centre is a start as good and farther
      // away.
      const bool outside = closest.distance() > boundary_;
      const ClosestPoint own{closest.point, squared_length(candidate.point - closest.point),
                             closest.triangle};
      const ToleranceVolume::Escape escape =
          outside ? volume_.escape(candidate.center, closest) : volume_.escape(candidate.point, own);
      candidate.reached = escape.reached;
      known_region_ = escape.region;
      known_center_ = escape.reached;
      known_radius_ = escape.distance - boundary_;
      if (!escape.region.valid()) {
        const bool has_side = escape.distance > volume_.thresholds().reject;
        if (has_side && volume_.sides().known()) set_label(candidate, volume_.sides().label(escape.reached));
        candidate.ask_octree = has_side && !candidate.has_point;
        return;
      }
    }
    candidate.region = known_region_;
    set_label(candidate, volume_.regions()[known_region_.index()].label);
  }

  /// The same where no ray leads to the point: from the point itself outwards.
  void find_side_from_the_point(SampleCandidate& candidate, TriangleId guess) {
    const ClosestPoint own = volume_.field().closest_near(candidate.point, guess);
    candidate.volume_component = volume_.volume_component(own.triangle);
    const ToleranceVolume::Escape escape = volume_.escape(candidate.point, own);
    candidate.reached = escape.reached;
    candidate.region = escape.region;
    if (volume_.open_sides() != nullptr && volume_.open_sides()->is_open(own.triangle))
      return set_label(candidate, volume_.open_sides()->side(candidate.point, own));
    const bool has_side = escape.distance > volume_.thresholds().reject;
    if (escape.region.valid())
      set_label(candidate, volume_.regions()[escape.region.index()].label);
    else if (const int side = volume_.field().side(candidate.point))
      set_label(candidate, side);
    else
      candidate.ask_octree = has_side;
  }

  /// Whether a ball that holds no point of Ω', around a point a little farther out, overlaps one in the known
  /// region.
  bool meets_known_ball(const SampleCandidate& candidate, const ClosestPoint& closest) const {
    const double d = closest.distance(), t = std::max(d, step_out * boundary_), sure = t * (1 - 1e-9);
    const Vec3 w = closest.point + (t / d) * (candidate.center - closest.point);
    if (distance(w, known_center_) >= (sure - boundary_ + known_radius_) * (1 - 1e-9)) return false;
    return d >= t || volume_.field().closest_near(w, closest.triangle, near_, sure).distance() >= sure;
  }

  static void set_label(SampleCandidate& candidate, int label) {
    candidate.label = static_cast<std::int8_t>(label);
    candidate.has_point = true;
  }

  const ToleranceVolume& volume_;
  const CandidateOptions& options_;
  double boundary_;
  std::vector<SampleCandidate>& out_;
  TriangleNeighborhood near_; ///< of the cube at hand
  Vec3 known_center_;         ///< of a ball outside of Ω', in the known region
  double known_radius_ = 0;
  RegionId known_region_; ///< behind the last point of this cell
};

} // namespace

double farthest_in_cube(Vec3 p, Vec3 center, double half_side) {
  const Vec3 d{std::abs(p.x - center.x) + half_side, std::abs(p.y - center.y) + half_side,
               std::abs(p.z - center.z) + half_side};
  return length(d);
}

CandidateCube cube_of(const ToleranceVolume& volume, const Regions::Cell& main_cell) {
  const Vec3 center = volume.octree().center(main_cell);
  ClosestPoint closest = volume.field().at_site(center, main_cell.triangle);
  if (!std::isfinite(closest.squared_distance))
    closest = volume.field().closest_near(center, main_cell.triangle);
  return {center, volume.octree().side(main_cell.level), closest};
}

void split_cube(const ToleranceVolume& volume, const CandidateCube& cube, double widest,
                std::vector<CandidateCube>& parts) {
  const double d = cube.closest.distance(), side = cube.side;
  if (!may_hold_boundary(d, half_diagonal * side, volume.thresholds().boundary)) return;
  if (side <= widest * (1 + 1e-9)) {
    parts.push_back(cube);
    return;
  }
  for (unsigned k = 0; k < 8; ++k) {
    const Vec3 c = cube.center + corner(k, 0.25 * side);
    split_cube(volume, {c, 0.5 * side, volume.field().closest_near(c, cube.closest.triangle)}, widest, parts);
  }
}

void find_candidates(const ToleranceVolume& volume, const CandidateCube& cube,
                     const CandidateOptions& options, std::vector<SampleCandidate>& candidates) {
  std::vector<CandidateCube> parts;
  split_cube(volume, cube, options.target_bound, parts);
  Subdivision subdivision(volume, options, candidates);
  for (const CandidateCube& part : parts) subdivision.visit_cube(part);
}

} // namespace isoscope
