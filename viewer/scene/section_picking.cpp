// What lies under the mouse in the 2D section.
#include "scene/picking.h"
#include "scene/section_view.h"

#include "mesh/sample_sets.h"

#include <algorithm>
#include <cmath>

namespace isoscope {

Pick pick_section_scene(const StateSnapshot& state, const InputPoints* points,
                        const Renderer::SectionView& section, const ViewSettings& view, const PickAt& at,
                        PickKinds kinds) {
  const SectionPlane plane = section_plane(view.clip);
  const double unit = section.height / at.height;
  const PlanePoint here{section.u + (at.x - 0.5 * at.width) * unit,
                        section.v + (0.5 * at.height - at.y) * unit};
  Pick best;
  double nearest = at.radius * unit;
  const auto offer = [&](Pick::Kind kind, std::size_t id, Vec3 p) {
    const PlanePoint q = plane.project(p);
    const double away = std::hypot(q.u - here.u, q.v - here.v);
    if (away >= nearest) return;
    nearest = away;
    best = {kind, static_cast<std::uint32_t>(id), p};
  };
  const double reach = section_sample_distance(state);
  if (has(kinds, PickKinds::samples) && view.samples.shown() && state.samples) {
    for (std::size_t i = 0; i < state.samples->size(); ++i) {
      const Vec3 p = state.samples->positions[i];
      if (std::abs(plane.height(p)) > reach) continue;
      const bool bad = i < state.errors.size() && is_bad(static_cast<double>(state.errors[i]));
      if ((bad ? view.bad_samples : view.good_samples).shown()) offer(Pick::Kind::sample, i, p);
    }
    const auto& over_rim = state.samples->over_rim;
    for (std::size_t i = 0; i < over_rim.size() && view.over_rim.shown(); ++i)
      if (std::abs(plane.height(over_rim[i])) <= reach) offer(Pick::Kind::over_rim, i, over_rim[i]);
  }
  if (has(kinds, PickKinds::points) && view.points.shown() && points != nullptr)
    for (std::size_t i = 0; i < points->size(); ++i)
      if (std::abs(plane.height(points->position(i))) <= section_point_distance(*points))
        offer(Pick::Kind::point, i, points->position(i));
  if (has(kinds, PickKinds::vertices)) {
    for (std::size_t i = 0; i < state.complex.vertices.size(); ++i) {
      const Vertex& v = state.complex.vertices[i];
      if (v.alive && (v.kind != VertexKind::box || view.tets.box) &&
          std::abs(plane.height(v.position)) <= reach)
        offer(Pick::Kind::vertex, i, v.position);
    }
  }
  if (best.kind == Pick::Kind::none && has(kinds, PickKinds::edges) && view.zero_set.shown() &&
      state.complex.form != ZeroForm::interpolated) {
    // Edges of Z that the plane crosses: they are points there.
    for (const ZeroSet::Polygon& p : state.zero_set.polygons)
      for (std::size_t i = 0; i < p.count; ++i) {
        const auto &a = state.zero_set.vertices[p.v[i]], &b = state.zero_set.vertices[p.v[(i + 1) % p.count]];
        const double ha = plane.height(a.position), hb = plane.height(b.position);
        if ((ha >= 0) == (hb >= 0)) continue;
        const auto [v, w] = std::minmax(a.negative, b.negative);
        offer(Pick::Kind::edge, v.value, a.position + ha / (ha - hb) * (b.position - a.position));
        if (best.kind == Pick::Kind::edge && best.id == v.value && best.other == Pick().other)
          best.other = w.value;
      }
  }
  if (best.kind == Pick::Kind::none && has(kinds, PickKinds::tetrahedra)) {
    const TetId tet = section_tet(state, plane, here, view.tets.box);
    if (tet.valid()) best = {Pick::Kind::tet, tet.value, plane.lift(here)};
  }
  return best;
}

} // namespace isoscope
