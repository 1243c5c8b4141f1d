// What the clip leaves to be seen: points, whole cells, stretches of a ray.
#pragma once

#include "base/geometry.h"
#include "scene/view_settings.h"

#include <array>
#include <span>
#include <vector>

namespace isoscope {

/// The clip as a signed region. A plane keeps its negative side, a slab and a ball keep their inside;
/// flipped: the rest.
class Clip {
 public:
  explicit Clip(const ClipSettings& settings) : settings_(settings) {}

  bool active() const { return settings_.shape != ClipSettings::Shape::none; }
  /// Whether fragments are cut away (otherwise cells are shown or hidden as wholes).
  bool cuts() const { return active() && settings_.mode == ClipSettings::Mode::cut; }
  /// Distance to the clip's surface, positive where kept; infinite without a clip.
  double kept_distance(Vec3 p) const;
  bool keeps(Vec3 p) const { return kept_distance(p) >= 0; }
  /// Whether a cell (tetrahedron, triangle) with these corners is drawn. cut: something of it may be left;
  /// whole_cells: its centroid is kept; straddle: its corners lie on both sides of the clip's surface.
  bool shows_cell(std::span<const Vec3> corners) const;
  /// Whether a lone point is drawn; `cell` is the tetrahedron that holds it, empty when unknown. straddle
  /// shows the points of straddling cells.
  bool shows_point(Vec3 p, std::span<const Vec3> cell) const;

  /// Stretches [a, b] of origin + t·direction that are kept, within [lo, hi], ascending. Whole-cell modes cut
  /// Ω all the same.
  std::vector<std::array<double, 2>> kept_intervals(Vec3 origin, Vec3 direction, double lo, double hi) const;

  const ClipSettings& settings() const { return settings_; }

 private:
  bool straddles(std::span<const Vec3> corners) const;
  ClipSettings settings_;
};

} // namespace isoscope
