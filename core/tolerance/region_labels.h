// Gives each region of the complement its side: + outside, - inside (§2.2).
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/tolerance_volume.h"

#include <cstdint>
#include <vector>

namespace isoscope {

/// Labels by region of a volume whose regions and boundary components are known, where the input's sides are.
/// Of no use once the control is cancelled.
std::vector<int> label_by_sides(const ToleranceVolume& volume, const RunControl& control);

/// The sides of the components of Ω' that do not separate two regions: open surfaces, as far as they are no
/// closed parts that are thinner than Ω. Null where there are none. Each needs a rim, and an orientation of
/// its triangles that tells two sides: fails with open_surface. Of no use once the control is cancelled.
Result<std::shared_ptr<const OpenSides>> find_open_sides(const ToleranceVolume& volume,
                                                         const RunControl& control);

/// A 1 by component of Ω' for open ones whose triangles are not joined; empty where there are none, or others
/// are open too. Of no use once the control is cancelled.
std::vector<std::uint8_t> find_loose_sheets(const ToleranceVolume& volume, const RunControl& control);

/// Labels for soups: alternating sides from the unbounded region. Where three regions or more meet a
/// component of Ω', as they do at pockets, rays decide if they agree; where they do not there are none: the
/// input has rooms. Regions that lie behind open surfaces only are pockets along these and have the side that
/// they are on. Fails with open_surface, with anything once the control is cancelled.
Result<std::vector<int>> label_by_two_colouring(const ToleranceVolume& volume, const RunControl& control);

/// Labels for points, which nothing but Ω tells the sides of. Deep regions, which reach beyond deep_enough δ,
/// alternate across components of Ω'; shallow ones, pockets in it, go with the deep region to which the way
/// over the largest φ leads first.
struct DepthLabels {
  std::vector<int> of_regions;
  std::vector<bool> shallow;         ///< by region
  std::vector<std::int8_t> of_cells; ///< by leaf of the octree as it was: where a pocket there would go
};
/// Of no use once the control is cancelled.
DepthLabels label_by_depth(const ToleranceVolume& volume, const RunControl& control);
/// The labels of deep regions, and those of shallow ones, which are 0 before, after them.
DepthLabels spread_labels(const ToleranceVolume& volume, std::vector<int> of_regions,
                          const RunControl& control);

/// What is said where inside and outside turn out to be one: open_surface_near(), in words for points where
/// depths tell the sides.
Error joined_sides_near(const ToleranceVolume& volume, Vec3 p);

/// The label of the region that ways up from p, which is outside of Ω', lead to; 0 where that is not told.
int label_above(const ToleranceVolume& volume, Vec3 p);

/// A point midway between a wall of the input and the next one along the normal.
struct ThicknessProbe {
  Vec3 middle;
  double distance = 0; ///< d(middle)
  TriangleId wall;     ///< the triangle that it was looked for from
};

/// Probes on both sides of at most 2000 triangles of a component of Ω', in the order of their ids; walls
/// farther apart than 8 δ are not seen. Fewer once the control is cancelled.
std::vector<ThicknessProbe> probe_thickness(const ToleranceVolume& volume, std::uint32_t component,
                                            const RunControl& control = {});

/// The deepest of the probe and 26 places around it at a distance of `step`.
ThicknessProbe deepest_around(const ToleranceField& field, const ThicknessProbe& from, double step);

/// Where d is locally largest, reached by steps that stay within the ball around the probe and so on its
/// side; ends where d is `enough`.
ThicknessProbe climb(const ToleranceField& field, ThicknessProbe from, double enough);

} // namespace isoscope
