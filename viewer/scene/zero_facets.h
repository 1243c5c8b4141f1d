// The facets of Z as they are drawn and picked: clipped by cells where there are any, and before or after the
// current operation.
#pragma once

#include "questions/snapshot.h"
#include "scene/clip.h"
#include "scene/view_settings.h"

#include <span>

namespace isoscope {

/// The corners by which a clip of whole cells decides on a polygon: the tetrahedron that carries interpolated
/// Z, else the polygon itself.
struct ClipCell {
  std::array<Vec3, 4> corners;
  std::size_t count = 0;
  std::span<const Vec3> span() const { return std::span(corners).first(count); }
};
ClipCell clip_cell(const StateSnapshot& state, const ZeroSet::Polygon& polygon);

/// Whether a clip of whole cells lets the polygon be seen; always true for one that cuts.
bool shows_polygon(const StateSnapshot& state, const ZeroSet::Polygon& polygon, const Clip& clip);

/// For each polygon of Z, whether the current operation put it there. Embedded and free Z only: all false
/// otherwise.
std::vector<std::uint8_t> new_polygons(const StateSnapshot& state);

} // namespace isoscope
