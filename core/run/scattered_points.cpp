// How many points are left, and what would join the others.
#include "run/scattered_points.h"

#include "base/numbers.h"
#include "base/place.h"

#include <algorithm>
#include <string>
#include <vector>

namespace isoscope {
namespace {

/// So many of the points must be kept.
constexpr double least_kept = 0.5;
/// Tolerances that may join the points grow by this factor, up to that many times.
constexpr double next_joining = 1.1;
constexpr int most_joining = 60;

double largest_share(const WeightedPointIndex& index, double boundary, const RunControl& control) {
  const VolumeComponents parts = index.components(boundary, control);
  std::vector<std::size_t> sizes(parts.count);
  for (const std::uint32_t c : parts.of_triangle)
    if (c != VolumeComponents::none) ++sizes[c];
  const std::size_t most = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
  return static_cast<double>(most) / static_cast<double>(index.size());
}

std::optional<double> joining_tolerance(const MadePointField& kept, const ToleranceThresholds& now,
                                        const RunControl& control) {
  const MadePointField all = with_all_sites(kept, control);
  double factor = next_joining;
  for (int tried = 0; tried < most_joining && !control.cancelled(); ++tried, factor *= next_joining)
    if (largest_share(*all.index, factor * now.boundary, control) >= least_kept) return factor * now.delta;
  return std::nullopt;
}

} // namespace

std::optional<Error> scattered(const MadePointField& kept, const ToleranceVolume& volume,
                               const RunControl& control) {
  const std::size_t all = kept.points->points->points.size();
  const std::size_t left = volume.volume_component_count() == 0 ? 0 : kept.index->size();
  if (static_cast<double>(left) >= least_kept * static_cast<double>(all)) return std::nullopt;
  Vec3 at = kept.points->points->points.front();
  std::size_t most = 0;
  for (const DroppedPoints& d : kept.points->dropped)
    if (d.why == DroppedPoints::Why::blob && d.points > most) most = d.points, at = d.place;
  const auto joining = joining_tolerance(kept, volume.thresholds(), control);
  return Error{
      ErrorCode::open_surface,
      "At this tolerance the points do not hang together: of " + counted(all, "point") + ", " +
          grouped(all - left) +
          " are farther from others than Ω is thick, or in small parts that enclose nothing, as near " +
          place(at, place_digits) + ".",
      joining ? "From δ = " + general(*joining, 3) +
                    " on half of them are in one part: choose a tolerance of that or more."
              : "No tolerance was found that joins half of them."};
}

} // namespace isoscope
