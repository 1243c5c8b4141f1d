// Facets of Z against the clip and the current operation.
#include "scene/zero_facets.h"

#include "base/point_order.h"

#include <algorithm>

namespace isoscope {
namespace {

Triangle3 sorted(Triangle3 t) {
  std::sort(t.begin(), t.end(), lies_before);
  return t;
}

bool less_triangle(const Triangle3& a, const Triangle3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), lies_before);
}

} // namespace

ClipCell clip_cell(const StateSnapshot& state, const ZeroSet::Polygon& polygon) {
  if (state.complex.form == ZeroForm::interpolated && polygon.tet.valid())
    return {state.complex.positions(polygon.tet), 4};
  ClipCell cell;
  cell.count = polygon.count;
  for (std::size_t i = 0; i < cell.count; ++i)
    cell.corners[i] = state.zero_set.vertices[polygon.v[i]].position;
  return cell;
}

bool shows_polygon(const StateSnapshot& state, const ZeroSet::Polygon& polygon, const Clip& clip) {
  return !clip.active() || clip.cuts() || clip.shows_cell(clip_cell(state, polygon).span());
}

std::vector<std::uint8_t> new_polygons(const StateSnapshot& state) {
  std::vector<std::uint8_t> is_new(state.zero_set.polygons.size(), 0);
  if (state.added_facets.empty()) return is_new;
  std::vector<Triangle3> added;
  for (const Triangle3& t : state.added_facets) added.push_back(sorted(t));
  std::sort(added.begin(), added.end(), less_triangle);
  for (std::size_t i = 0; i < is_new.size(); ++i) {
    const ZeroSet::Polygon& polygon = state.zero_set.polygons[i];
    if (polygon.count != 3) continue;
    Triangle3 t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = state.zero_set.vertices[polygon.v[k]].position;
    is_new[i] = std::binary_search(added.begin(), added.end(), sorted(t), less_triangle);
  }
  return is_new;
}

} // namespace isoscope
