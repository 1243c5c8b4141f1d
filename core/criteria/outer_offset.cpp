// Distances to outer samples, and the lattice that counts what is within them.
#include "criteria/outer_offset.h"

#include "tolerance/regions.h"

#include <algorithm>
#include <array>
#include <limits>

namespace isoscope {
namespace {

/// The lattice is at most so wide, in units of δ'.
constexpr double widest_lattice = 0.3;
/// How far the points reach: enough to be connected from sample to sample, in units of σ; within Ω, in units
/// of δ'.
constexpr double reach_by_sigma = 1.3, least_reach = 0.5, most_reach = 0.95;
/// Reaches that are tried where counts do not agree, in units of δ'.
constexpr std::array other_reaches{0.9, 0.8, 0.6, 0.95, 0.85, 0.75, 0.65};
/// The usual reach is doubted where one so much larger, in units of δ', has another count.
constexpr double doubted_by = 0.1;
/// Of a distance to the input: nearer than this, nothing of it is between.
constexpr double surely_clear = 1 - 1e-9;

/// Whether it is the count of closed surfaces.
bool is_closed(const BoundaryCount& count) {
  return count.euler_characteristic % 2 == 0;
}

ExpectedTopology expectation(const BoundaryCount& count, double reach) {
  ExpectedTopology expected;
  expected.euler_characteristic = count.euler_characteristic;
  expected.components = count.pieces;
  expected.source = "the outer boundary of Ω";
  expected.joined = true;
  expected.reach = reach;
  return expected;
}

} // namespace

double OuterOffset::usual_reach(const ToleranceVolume& volume, double sigma) {
  const double boundary = volume.thresholds().boundary;
  return std::clamp(reach_by_sigma * sigma, least_reach * boundary, most_reach * boundary);
}

OuterOffset::OuterOffset(const ToleranceVolume& volume, const NearestSample& samples, double reach)
    : volume_(volume), samples_(samples), reach_(reach) {
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

bool OuterOffset::is_in(Vec3 p, TriangleId guess) const {
  if (samples_.has_near(p, +1, reach_)) return true;
  const double d = volume_.index().closest_near(p, guess).distance();
  return d >= volume_.thresholds().boundary && is_outside(p, d);
}

bool OuterOffset::is_near(Vec3 p, double radius) const {
  const SampleId nearest = samples_.nearest_of(p, +1, reach_ + radius);
  if (!nearest.valid() || distance(p, samples_.positions()[nearest.index()]) < reach_ - radius) return false;
  const double d = volume_.index().distance(p);
  return d - volume_.thresholds().boundary <= radius || !is_outside(p, d);
}

std::optional<BoundaryCount> OuterOffset::count(unsigned halvings, const RunControl& control) const {
  OffsetCounting counting;
  counting.halvings = halvings;
  counting.reach = reach_;
  counting.outside = [&](Vec3 p, TriangleId guess) { return is_in(p, guess); };
  counting.near = [&](Vec3 p, double radius) { return is_near(p, radius); };
  const auto counted = count_offset(volume_, counting, control);
  return counted ? std::optional(*counted) : std::nullopt;
}

std::optional<ExpectedTopology> outer_offset_topology(const ToleranceVolume& volume,
                                                      const NearestSample& samples, double sigma,
                                                      const RunControl& control) {
  const double boundary = volume.thresholds().boundary;
  const Regions& octree = volume.octree();
  unsigned halvings = 0;
  while (octree.side(octree.main_level() + halvings) > widest_lattice * boundary) ++halvings;
  const auto count = [&](double reach, unsigned more) {
    return OuterOffset(volume, samples, reach).count(halvings + more, control);
  };
  const double usual = OuterOffset::usual_reach(volume, sigma);
  const double larger = std::min(usual + doubted_by * boundary, most_reach * boundary);
  const auto counted = count(usual, 0), other = counted ? count(larger, 0) : std::nullopt;
  if (!other) return std::nullopt;
  if (is_closed(*counted) && *counted == *other) return expectation(*counted, usual);

  std::vector<double> reaches{usual};
  for (const double share : other_reaches)
    if (share * boundary >= sigma) reaches.push_back(share * boundary);
  for (const double reach : reaches) {
    const auto first = reach == usual ? counted : count(reach, 0);
    const auto finer = first ? count(reach, 1) : std::nullopt;
    if (!finer) break; // no other is much smaller
    if (is_closed(*first) && *first == *finer) return expectation(*first, reach);
  }
  if (control.cancelled() || !(is_closed(*counted) || is_closed(*other))) return std::nullopt;
  ExpectedTopology unsure = expectation(is_closed(*counted) ? *counted : *other, usual);
  unsure.required = false;
  unsure.source += ", whose handles are too small to be counted";
  return unsure;
}

} // namespace isoscope
