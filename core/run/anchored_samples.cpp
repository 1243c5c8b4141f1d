// Looks from the closest point through the sample as far as balls fit, and beside open surfaces climbs on.
#include "run/anchored_samples.h"

#include "run/touching_ball.h"

namespace isoscope {
namespace {

/// In δ: what is farther away than δ by this is beyond it, and so far a ball is blown up.
constexpr double just_beyond = 1e-4, largest_ball = 1.05;
/// In δ, from a sample away from the input: mostly in a cell of what lies around.
constexpr double glance = 0.6;

} // namespace

AnchoredSamples::AnchoredSamples(const ToleranceVolume& volume, const BoundarySamples& samples,
                                 const RunControl& control)
    : volume_(volume), samples_(samples), known_(samples.size()) {
  if (volume.open_sides() == nullptr) return;
  cells_.emplace(volume.octree(), volume.thresholds().delta, DeepCells::everywhere, control);
  const Box3 domain = volume.domain();
  const DeepCells::CellIndex corner = volume.octree().locate(domain.lo + 1e-9 * domain.extent());
  if (corner != Regions::none && cells_->deep(corner)) around_ = cells_->group(corner);
}

bool AnchoredSamples::is_anchored(SampleId sample) const {
  std::atomic<std::int8_t>& known = known_[sample.index()];
  if (const std::int8_t told = known.load(std::memory_order_relaxed); told != 0) return told > 0;
  const bool anchored = find(samples_.positions[sample.index()]);
  known.store(anchored ? 1 : -1, std::memory_order_relaxed);
  return anchored;
}

bool AnchoredSamples::is_around(Vec3 p) const {
  const DeepCells::CellIndex i = volume_.octree().locate(p);
  return i == Regions::none || (cells_->deep(i) && cells_->group(i) == around_);
}

bool AnchoredSamples::find(Vec3 p) const {
  const ToleranceField& field = volume_.field();
  const ToleranceThresholds& limits = volume_.thresholds();
  const double delta = limits.delta, enough = (1 + just_beyond) * delta;
  const ClosestPoint foot = field.closest(p);
  const Vec3 out = normalized(p - foot.point);
  const bool open = cells_ && volume_.open_sides()->is_open(foot.triangle);
  const Vec3 further = p + (open ? glance * delta : enough - limits.boundary) * out;
  if (open ? is_around(further) : field.closest_near(further, foot.triangle).distance() >= delta) return true;
  const double radius = touching_radius(foot.point, out, largest_ball * delta,
                                        [&](Vec3 q) { return field.closest_near(q, foot.triangle).point; });
  if (!(radius > enough) || !open) return radius > enough;
  Vec3 at = foot.point + radius * out;
  double depth = 0;
  return climb(field, *cells_, delta, field.closest_near(at, foot.triangle), at, depth) && is_around(at);
}

} // namespace isoscope
