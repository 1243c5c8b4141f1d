// Distances to outer samples, and the lattice that counts what is within them.
#include "criteria/outer_offset.h"

#include "tolerance/boundary_topology.h"
#include "tolerance/regions.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>
#include <vector>

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

/// Whether a point of this d, beyond Ω', is outside. A ball without input is on one side, and mostly holds a
/// sample of it.
bool is_outside(const ToleranceVolume& volume, const NearestSample& samples, Vec3 p, double d) {
  const double clear = surely_clear * d;
  if (samples.has_near(p, +1, clear)) return true;
  if (samples.has_near(p, -1, clear)) return false;
  return volume.sides().label(p) > 0;
}

/// What lattices count of the boundaries of offsets of the outside.
class OffsetCounts {
 public:
  OffsetCounts(const ToleranceVolume& volume, const NearestSample& samples, const RunControl& control)
      : volume_(volume), samples_(samples), control_(control) {
    const Regions& octree = volume.octree();
    while (octree.side(octree.main_level() + halvings_) > widest_lattice * volume.thresholds().boundary)
      ++halvings_;
  }

  /// Of each reach, ascending, on a lattice halved so often; nothing where that is too large, or once
  /// cancelled.
  std::optional<std::vector<BoundaryCount>> count(std::span<const double> reaches, unsigned halvings) const {
    OffsetCounting counting;
    counting.halvings = halvings_ + halvings;
    counting.reach = reaches.back();
    counting.sets = static_cast<unsigned>(reaches.size());
    counting.first_set = [&](Vec3 p, TriangleId guess) { return first_set(p, guess, reaches); };
    counting.near = [&](Vec3 p, double radius) { return is_near(p, radius, reaches); };
    auto counted = count_offsets(volume_, counting, control_);
    return counted ? std::optional(std::move(*counted)) : std::nullopt;
  }
  std::optional<BoundaryCount> count(double reach, unsigned halvings) const {
    const auto counted = count(std::array{reach}, halvings);
    return counted ? std::optional(counted->front()) : std::nullopt;
  }

 private:
  std::optional<unsigned> first_set(Vec3 p, TriangleId guess, std::span<const double> reaches) const {
    if (samples_.has_near(p, +1, reaches.front())) return 0;
    const double d = volume_.index().closest_near(p, guess).distance();
    if (d >= volume_.thresholds().boundary && is_outside(volume_, samples_, p, d)) return 0;
    for (unsigned i = 1; i < reaches.size(); ++i)
      if (samples_.has_near(p, +1, reaches[i])) return i;
    return std::nullopt;
  }

  /// Whether one of the boundaries may be within `radius` of p.
  bool is_near(Vec3 p, double radius, std::span<const double> reaches) const {
    const SampleId nearest = samples_.nearest_of(p, +1, reaches.back() + radius);
    if (!nearest.valid() || distance(p, samples_.positions()[nearest.index()]) < reaches.front() - radius)
      return false;
    const double d = volume_.index().distance(p);
    return d - volume_.thresholds().boundary <= radius || !is_outside(volume_, samples_, p, d);
  }

  const ToleranceVolume& volume_;
  const NearestSample& samples_;
  const RunControl& control_;
  unsigned halvings_ = 0; ///< of the octree's main cells, until they are narrow enough
};

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

double OuterOffset::depth(Vec3 p) const {
  const double d = volume_.index().distance(p), boundary = volume_.thresholds().boundary;
  if (d >= boundary && is_outside(volume_, samples_, p, d)) return boundary - d - reach_;
  double depth = std::numeric_limits<double>::infinity();
  if (const SampleId nearest = samples_.nearest_of(p, +1); nearest.valid())
    depth = distance(p, samples_.positions()[nearest.index()]) - reach_;
  for (const Ball& ball : held_) depth = std::min(depth, distance(p, ball.center) - ball.radius);
  return depth;
}

std::optional<ExpectedTopology> outer_offset_topology(const ToleranceVolume& volume,
                                                      const NearestSample& samples, double sigma,
                                                      const RunControl& control) {
  const double boundary = volume.thresholds().boundary;
  const OffsetCounts counts(volume, samples, control);
  const double usual = OuterOffset::usual_reach(volume, sigma);
  const double larger = std::min(usual + doubted_by * boundary, most_reach * boundary);
  const auto both = counts.count(std::array{usual, larger}, 0);
  if (!both) return std::nullopt;
  const BoundaryCount &counted = both->front(), &other = both->back();
  if (is_closed(counted) && counted == other) return expectation(counted, usual);

  std::vector<double> reaches{usual};
  for (const double share : other_reaches)
    if (share * boundary >= sigma) reaches.push_back(share * boundary);
  for (const double reach : reaches) {
    const auto first = reach == usual ? std::optional(counted) : counts.count(reach, 0);
    const auto finer = first ? counts.count(reach, 1) : std::nullopt;
    if (!finer) break; // no other is much smaller
    if (is_closed(*first) && *first == *finer) return expectation(*first, reach);
  }
  if (control.cancelled() || !(is_closed(counted) || is_closed(other))) return std::nullopt;
  ExpectedTopology unsure = expectation(is_closed(counted) ? counted : other, usual);
  unsure.required = false;
  unsure.source += ", whose handles are too small to be counted";
  return unsure;
}

} // namespace isoscope
