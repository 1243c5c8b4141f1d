// Subdivides a cell until a boundary point close enough to all of each part is known.
#include "tolerance/sample_candidates.h"

#include <optional>

namespace isoscope {
namespace {

constexpr double half_diagonal = 0.86602540379 * (1 + 1e-7);
/// How far from δ' a projected point may be, relative to δ'.
constexpr double projection_error = 1e-11;

class Subdivision {
 public:
  Subdivision(const ToleranceVolume& volume, const CandidateOptions& options,
              std::vector<SampleCandidate>& out)
      : volume_(volume), options_(options), boundary_(volume.thresholds().boundary), out_(out) {}

  void visit(Vec3 center, double side, TriangleId guess) {
    const ClosestPoint closest = volume_.index().closest_near(center, guess);
    const double d = closest.distance(), reach = half_diagonal * side;
    if (d > boundary_ + reach || d + reach < boundary_) return;

    SampleCandidate candidate;
    candidate.center = center;
    candidate.half_side = 0.5 * side;
    bool last = 0.5 * side < options_.smallest_side;
    if (reach <= options_.target_bound && project(candidate, closest, last)) {
      find_side(candidate, closest);
      last = last || 0.5 * side < options_.crevice_side;
    }
    if (candidate.has_point || last) {
      out_.push_back(candidate);
      return;
    }
    visit_children(center, side, closest.triangle);
  }

  void visit_children(Vec3 center, double side, TriangleId guess) {
    const double q = 0.25 * side;
    for (unsigned k = 0; k < 8; ++k)
      visit(center + Vec3{k & 1u ? q : -q, k & 2u ? q : -q, k & 4u ? q : -q}, 0.5 * side, guess);
  }

 private:
  /// Finds the point at δ' on the ray from the closest point through the centre, if it covers the cell. Seen
  /// from outside it is exact; from inside another part of the input may be nearer there, which one more
  /// query tells.
  bool project(SampleCandidate& candidate, const ClosestPoint& closest, bool last) const {
    const double d = closest.distance();
    if (!(d > 1e-6 * boundary_)) return false;
    const Vec3 q = closest.point + (boundary_ / d) * (candidate.center - closest.point);
    candidate.point = snap(q);
    const double bound = farthest_in_cube(candidate.point, candidate.center, candidate.half_side);
    if (bound > options_.target_bound && !last) return false;
    return d >= boundary_ ||
           volume_.index().closest_near(q, closest.triangle).distance() >= boundary_ * (1 - projection_error);
  }

  Vec3 snap(Vec3 p) const {
    for (int a = 0; a < 3; ++a) p[a] = std::round(p[a] / options_.snap_unit) * options_.snap_unit;
    return p;
  }

  void find_side(SampleCandidate& candidate, const ClosestPoint& closest) {
    candidate.volume_component = volume_.volume_component(closest.triangle);
    if (!options_.one_region_a_cell || !known_region_.valid()) {
      // From outside the way to the boundary point is straight, so the centre is a start as good and farther
      // away.
      const bool outside = closest.distance() > boundary_;
      const ClosestPoint own{closest.point, squared_length(candidate.point - closest.point),
                             closest.triangle};
      const ToleranceVolume::Escape escape =
          outside ? volume_.escape(candidate.center, closest) : volume_.escape(candidate.point, own);
      candidate.reached = escape.reached;
      known_region_ = escape.region;
      if (!escape.region.valid()) {
        const bool has_side = escape.distance > volume_.thresholds().reject;
        if (has_side && volume_.input().closed_manifold)
          set_label(candidate, volume_.index().inside_by_parity(escape.reached) ? -1 : +1);
        candidate.ask_octree = has_side && !candidate.has_point;
        return;
      }
    }
    candidate.region = known_region_;
    set_label(candidate, volume_.regions()[known_region_.index()].label);
  }

  static void set_label(SampleCandidate& candidate, int label) {
    candidate.label = static_cast<std::int8_t>(label);
    candidate.has_point = true;
  }

  const ToleranceVolume& volume_;
  const CandidateOptions& options_;
  double boundary_;
  std::vector<SampleCandidate>& out_;
  RegionId known_region_; ///< behind the last point of this cell
};

} // namespace

double farthest_in_cube(Vec3 p, Vec3 center, double half_side) {
  const Vec3 d{std::abs(p.x - center.x) + half_side, std::abs(p.y - center.y) + half_side,
               std::abs(p.z - center.z) + half_side};
  return length(d);
}

void find_candidates(const ToleranceVolume& volume, const Regions::Cell& cell,
                     const CandidateOptions& options, std::vector<SampleCandidate>& candidates) {
  const Regions& octree = volume.octree();
  Subdivision subdivision(volume, options, candidates);
  const double side = octree.side(cell.level);
  if (half_diagonal * side <= options.target_bound)
    subdivision.visit(octree.center(cell), side, cell.triangle);
  else
    subdivision.visit_children(octree.center(cell), side, cell.triangle);
}

} // namespace isoscope
