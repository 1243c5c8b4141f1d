// Distances to outer samples, and the lattice that counts what is within them.
#include "criteria/outer_offset.h"

#include "tolerance/boundary_topology.h"
#include "tolerance/regions.h"

#include <algorithm>
#include <limits>

namespace isoscope {
namespace {

/// The lattice is at most so wide, in units of δ'.
constexpr double widest_lattice = 0.3;
/// How far the points reach: enough to be connected from sample to sample, in units of σ; within Ω, in units
/// of δ'.
constexpr double reach_by_sigma = 1.3, least_reach = 0.5, most_reach = 0.95;
/// Of a distance to the input: nearer than this, nothing of it is between.
constexpr double surely_clear = 1 - 1e-9;

} // namespace

OuterOffset::OuterOffset(const ToleranceVolume& volume, const NearestSample& samples, double sigma)
    : volume_(volume), samples_(samples) {
  const double boundary = volume.thresholds().boundary;
  reach_ = std::clamp(reach_by_sigma * sigma, least_reach * boundary, most_reach * boundary);
  for (const Witness& w : volume.cover_path())
    if (w.label > 0) held_.push_back({w.point, volume.index().distance(w.point)});
}

bool OuterOffset::is_outside(Vec3 p, double d) const {
  const double clear = surely_clear * d;
  if (samples_.has_near(p, +1, clear)) return true;
  if (samples_.has_near(p, -1, clear)) return false;
  return volume_.sides().label(p) > 0;
}

double OuterOffset::depth(Vec3 p) const {
  const double d = volume_.index().distance(p), boundary = volume_.thresholds().boundary;
  if (d >= boundary && is_outside(p, d)) return boundary - d - reach_;
  double depth = std::numeric_limits<double>::infinity();
  if (const SampleId nearest = samples_.nearest_of(p, +1); nearest.valid())
    depth = distance(p, samples_.positions()[nearest.index()]) - reach_;
  for (const Ball& ball : held_) depth = std::min(depth, distance(p, ball.center) - ball.radius);
  return depth;
}

std::optional<ExpectedTopology> OuterOffset::topology(const RunControl& control) const {
  const Regions& octree = volume_.octree();
  OffsetCounting counting;
  counting.reach = reach_;
  while (octree.side(octree.main_level() + counting.halvings) >
         widest_lattice * volume_.thresholds().boundary)
    ++counting.halvings;
  const double boundary = volume_.thresholds().boundary;
  counting.outside = [&](Vec3 p, double d) {
    return d >= boundary ? is_outside(p, d) : samples_.has_near(p, +1, reach_);
  };
  const auto count = count_offset(volume_, counting, control);
  if (!count || count->euler_characteristic % 2 != 0) return std::nullopt;
  ExpectedTopology expected;
  expected.euler_characteristic = count->euler_characteristic;
  expected.components = count->pieces;
  expected.source = "the outer boundary of Ω";
  expected.joined = true;
  return expected;
}

} // namespace isoscope
