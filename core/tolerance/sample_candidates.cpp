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
    const bool last = 0.5 * side < options_.smallest_side;
    if (const auto point = project(center, closest)) {
      candidate.point = *point;
      candidate.bound = farthest_in_cube(*point, center, 0.5 * side);
      candidate.has_point = candidate.bound <= options_.target_bound || last;
      if (candidate.has_point) find_region(candidate, closest);
    }
    if (candidate.has_point || last) {
      out_.push_back(candidate);
      return;
    }
    for (unsigned k = 0; k < 8; ++k) {
      const double q = 0.25 * side;
      visit(center + Vec3{k & 1u ? q : -q, k & 2u ? q : -q, k & 4u ? q : -q}, 0.5 * side, closest.triangle);
    }
  }

 private:
  /// The point at δ' on the ray from the closest point through p. Seen from outside it is exact; from inside
  /// another part of the input may be nearer there, which one more query tells.
  std::optional<Vec3> project(Vec3 p, const ClosestPoint& closest) const {
    const double d = closest.distance();
    if (!(d > 1e-6 * boundary_)) return std::nullopt;
    const Vec3 q = closest.point + (boundary_ / d) * (p - closest.point);
    if (d < boundary_ &&
        volume_.index().closest_near(q, closest.triangle).distance() < boundary_ * (1 - projection_error))
      return std::nullopt;
    return snap(q);
  }

  Vec3 snap(Vec3 p) const {
    for (int a = 0; a < 3; ++a) p[a] = std::round(p[a] / options_.snap_unit) * options_.snap_unit;
    return p;
  }

  void find_region(SampleCandidate& candidate, const ClosestPoint& closest) const {
    candidate.volume_component = volume_.volume_component(closest.triangle);
    const ClosestPoint own{closest.point, squared_length(candidate.point - closest.point), closest.triangle};
    const ToleranceVolume::Escape escape = volume_.escape(candidate.point, own);
    candidate.region = escape.region;
    if (escape.region.valid()) return;
    candidate.reached = escape.reached;
    candidate.ask_octree = escape.distance > volume_.thresholds().reject;
    candidate.has_point = candidate.ask_octree;
  }

  const ToleranceVolume& volume_;
  const CandidateOptions& options_;
  double boundary_;
  std::vector<SampleCandidate>& out_;
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
  Subdivision(volume, options, candidates).visit(octree.center(cell), octree.side(cell.level), cell.triangle);
}

} // namespace isoscope
