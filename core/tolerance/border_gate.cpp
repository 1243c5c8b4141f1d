// Branch and bound over pieces of segments. The distance to one segment is convex, so that two ends decide
// about a piece.
#include "tolerance/border_gate.h"

#include "tolerance/rounding.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace isoscope {
namespace {

constexpr std::size_t piece_budget = 4000;

double largest_end_distance(const Segment3& piece, const Segment3& to) {
  return std::max(distance_to(to, piece[0]), distance_to(to, piece[1]));
}

double least_distance(Vec3 p, std::span<const Segment3> segments) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment3& s : segments) least = std::min(least, distance_to(s, p));
  return least;
}

} // namespace

BorderGate::BorderGate(std::vector<Segment3> rim, double delta, std::vector<Segment3> crossed)
    : rim_(std::move(rim)), crossed_(std::move(crossed)), delta_(delta) {}

BorderVerdict BorderGate::keeps_to_rim(const Segment3& edge) const {
  if (rim_.segments().empty()) return {false, edge[0], std::numeric_limits<double>::infinity()};
  Box3 box;
  for (const Vec3 p : edge) box.add(p);
  const double rounding = rounding_bound(rim_.bounds(), box, bound_roundings);
  std::vector<Segment3> pieces{edge};
  for (std::size_t looked = 0; !pieces.empty(); ++looked) {
    const Segment3 piece = pieces.back();
    pieces.pop_back();
    const Vec3 middle = point_on(piece, 0.5);
    const ClosestOnSegments closest = rim_.closest(middle);
    if (closest.distance - rounding > delta_ || looked == piece_budget)
      return {false, middle, closest.distance};
    const double bound = std::min(closest.distance + 0.5 * distance(piece[0], piece[1]),
                                  largest_end_distance(piece, rim_.segments()[closest.segment]));
    if (bound + rounding <= delta_) continue;
    pieces.push_back({piece[0], middle});
    pieces.push_back({middle, piece[1]});
  }
  return {};
}

BorderVerdict BorderGate::covers_rim(std::span<const Segment3> before,
                                     std::span<const Segment3> after) const {
  Box3 box;
  for (const Segment3& s : before)
    for (const Vec3 p : s) box.add(p);
  if (box.empty()) return {};
  const double rounding = rounding_bound(rim_.bounds(), box, bound_roundings);
  std::vector<Segment3> pieces;
  std::size_t looked = 0;
  for (const std::uint32_t r : rim_.near(box.center(), 0.5 * length(box.extent()) + delta_)) {
    pieces.push_back(rim_.segments()[r]);
    while (!pieces.empty()) {
      const Segment3 piece = pieces.back();
      pieces.pop_back();
      const bool covered = std::any_of(after.begin(), after.end(), [&](const Segment3& s) {
        return largest_end_distance(piece, s) + rounding <= delta_;
      });
      if (covered) continue;
      const Vec3 middle = point_on(piece, 0.5);
      const double reach = 0.5 * distance(piece[0], piece[1]), d = least_distance(middle, before);
      if (d - reach - rounding > delta_) continue;
      if (const double left = least_distance(middle, after);
          (d <= delta_ && left - rounding > delta_) || ++looked == piece_budget)
        return {false, middle, left};
      pieces.push_back({piece[0], middle});
      pieces.push_back({middle, piece[1]});
    }
  }
  return {};
}

std::vector<Vec3> BorderGate::rim_samples() const {
  const double spacing = 0.5 * delta_;
  std::vector<Vec3> samples;
  for (const Segment3& s : rim_.segments()) {
    const double l = distance(s[0], s[1]);
    const auto parts = static_cast<int>(std::min(std::ceil(l / spacing), 1e6));
    for (int i = 0; i < parts; ++i) {
      const Vec3 p = point_on(s, static_cast<double>(i) / parts);
      if (i > 0 || samples.empty() || distance(samples.back(), p) >= 0.25 * spacing) samples.push_back(p);
    }
  }
  return samples;
}

} // namespace isoscope
