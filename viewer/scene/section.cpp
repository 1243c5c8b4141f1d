// Draws the 2D section as the paper's figures do.
#include "scene/section.h"

#include "scene/layer_preview.h"
#include "scene/pick_geometry.h"
#include "scene/section_attempt_layer.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace isoscope {
namespace {

/// Outline of a tetrahedron's section.
void outline(const std::array<Vec3, 4>& p, const SectionPlane& plane, const SceneSpace& space, Color8 tint,
             float width, bool dashed, LineBuilder& lines) {
  constexpr std::array<std::array<std::size_t, 3>, 4> facets{{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
  for (const auto& f : facets) {
    std::array<Vec3, 2> ends;
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3 && found < 2; ++i) {
      const Vec3 a = p[f[i]], b = p[f[(i + 1) % 3]];
      const double ha = plane.height(a), hb = plane.height(b);
      if ((ha >= 0) != (hb >= 0)) ends[found++] = a + ha / (ha - hb) * (b - a);
    }
    if (found == 2) lines.segment(space.local(ends[0]), space.local(ends[1]), tint, width, dashed);
  }
}

/// Points of the input near to the plane.
std::vector<Marker> near_points(const InputPoints& points, const SectionPlane& plane,
                                const ViewFrame& frame) {
  const double spacing = points.spacing * frame.pixels_per_unit / static_cast<double>(frame.pixel_scale);
  const auto diameter = static_cast<std::uint8_t>(
      std::clamp(std::min(1.3 * static_cast<double>(frame.view.sample_size), 1.2 * spacing), 3.0, 30.0));
  const auto cross = static_cast<std::uint8_t>(std::max<int>(diameter + 2, 7));
  const double reach = section_point_distance(points);
  std::vector<Marker> marks;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = points.position(i);
    if (std::abs(plane.height(p)) > reach) continue;
    const bool dropped = points.dropped(i);
    marks.push_back(
        {frame.space.local(plane.lift(plane.project(p))),
         color8(dropped ? frame.colors.dropped : weight_color(frame.view.theme, points.weights[i])),
         dropped ? MarkerShape::cross : MarkerShape::disc, dropped ? cross : diameter});
  }
  return marks;
}

/// Where the border of the input crosses the plane.
void add_rim(const Rim& rim, const SectionPlane& plane, const ViewFrame& frame, std::vector<Marker>& marks) {
  for (const RimCrossing& x : rim_crossings(rim, plane))
    marks.push_back({frame.space.local(plane.lift(x.at)), color8(frame.colors.rim, frame.view.rim.opacity),
                     x.open ? MarkerShape::ring : MarkerShape::circle, 13});
}

/// How a side is filled; without hatch where there is one inside.
WallStyle fill_style(int label, bool rooms, const SceneColors& colors) {
  const glm::vec3 color = side_color(label, rooms, colors);
  const WallStyle::Side side{color, color, rooms ? room_style(label).hatch : Hatch::none};
  return {side, side};
}

} // namespace

void SectionLayer::update(const LayerInputs& inputs, const ViewFrame& frame) {
  const StateSnapshot* const state = inputs.state.get();
  LineBuilder lines, marked;
  std::map<int, MeshBuilder> cells;
  std::vector<Marker> dots, samples, marks;
  if (inputs.points && frame.view.points.shown())
    dots = near_points(*inputs.points, section_plane(frame.view.clip), frame);
  if (inputs.rim() != nullptr && frame.view.rim.shown())
    add_rim(*inputs.rim(), section_plane(frame.view.clip), frame, marks);
  if (state) {
    const SceneColors& c = frame.colors;
    const SectionPlane plane = section_plane(frame.view.clip);
    const SectionGeometry geometry =
        section_geometry(*state, plane, {frame.view.tets.box, section_sample_distance(*state)});
    const auto add = [&](const std::vector<SectionGeometry::Segment>& segments, Color8 tint, float width) {
      for (const auto& s : segments)
        lines.segment(frame.space.local(plane.lift(s.a)), frame.space.local(plane.lift(s.b)), tint, width);
    };
    if (frame.view.side_tint && frame.view.tetrahedra.shown()) {
      const auto local = [&](PlanePoint p) { return frame.space.local(plane.lift(p)); };
      for (const SectionGeometry::Cell& cell : geometry.cells)
        for (std::size_t i = 1; i + 1 < cell.count; ++i)
          cells[cell.label].triangle(local(cell.corners[0]), local(cell.corners[i]),
                                     local(cell.corners[i + 1]),
                                     color8(side_color(cell.label, state->zero_set.has_rooms(), c)), 0);
    }
    const auto mark = [&](PlanePoint at, glm::vec3 color, MarkerShape shape, std::uint8_t diameter) {
      marks.push_back({frame.space.local(plane.lift(at)), color8(color), shape, diameter});
    };
    if (frame.view.curves.shown())
      for (const SectionGeometry::Crossing& x : geometry.crossings)
        mark(x.at, x.border ? c.section_zero : c.selection,
             x.border ? MarkerShape::disc : MarkerShape::square, 9);
    if (frame.view.tetrahedra.shown()) add(geometry.tetrahedra, color8(c.section_line), 1.0f);
    if (frame.view.gamma.shown()) add(geometry.gamma, color8(c.gamma), 1.8f);
    if (frame.view.dropped.shown())
      for (const auto& s : geometry.dropped)
        lines.segment(frame.space.local(plane.lift(s.a)), frame.space.local(plane.lift(s.b)), color8(c.rim),
                      1.8f, true);
    if (frame.view.zero_set.shown()) add(geometry.zero_set, color8(c.section_zero), 2.6f);
    if (inputs.other && frame.view.other_zero.shown())
      add(zero_segments(inputs.other->zero_set, plane), color8(c.other_zero, frame.view.other_zero.opacity),
          2.2f);
    if (frame.view.samples.shown()) {
      // Neighbours touch at most.
      const double spacing =
          state->samples ? state->samples->sigma * frame.pixels_per_unit / frame.pixel_scale : 30;
      const float size =
          std::clamp(std::min(1.5f * frame.view.sample_size, static_cast<float>(spacing)), 3.0f, 30.0f);
      const bool classified = state->classifies();
      for (const auto& s : geometry.samples) {
        if (!(s.bad ? frame.view.bad_samples : frame.view.good_samples).shown()) continue;
        const MarkerShape shape =
            s.bad ? MarkerShape::cross : (s.outer ? MarkerShape::disc : MarkerShape::circle);
        const auto diameter = static_cast<std::uint8_t>(s.bad ? std::max(1.4f * size, 6.0f) : size);
        samples.push_back({frame.space.local(plane.lift(s.at)),
                           color8(s.bad        ? c.bad
                                  : classified ? c.good
                                               : c.tetrahedron),
                           shape, diameter});
      }
      const auto diamond = static_cast<std::uint8_t>(std::max(1.3f * size, 6.0f));
      if (frame.view.over_rim.shown())
        for (const PlanePoint at : geometry.over_rim)
          samples.push_back({frame.space.local(plane.lift(at)), color8(c.rim, frame.view.over_rim.opacity),
                             MarkerShape::hollow_diamond, diamond});
    }
    if (inputs.preview) {
      const double near = section_sample_distance(*state);
      for_each_marked(
          *state, *inputs.preview,
          [&](SampleId s) {
            const Vec3 p = state->samples->positions[s.index()];
            if (std::abs(plane.height(p)) <= near)
              marks.push_back({frame.space.local(plane.lift(plane.project(p))), color8(c.warning, 0.9f),
                               MarkerShape::circle, 13});
          },
          [&](TetId t, bool misoriented) {
            outline(state->complex.positions(t), plane, frame.space,
                    color8(misoriented ? c.misoriented : c.warning, 0.9f), 1.6f, true, marked);
          });
    }
    const auto ring = [&](Vec3 p, glm::vec3 color, std::uint8_t diameter) {
      // Far from the plane the ring only hints at where the point is.
      const double reach = state->samples ? 4 * state->samples->sigma : 0;
      const bool near = std::abs(plane.height(p)) <= reach;
      marks.push_back({frame.space.local(plane.lift(plane.project(p))), color8(color, near ? 1.0f : 0.3f),
                       MarkerShape::ring, diameter});
    };
    if (frame.view.highlight.shown()) {
      if (state->violated_tet)
        outline(*state->violated_tet, plane, frame.space, color8(c.bad), 1.8f, true, marked);
      if (state->inserted.valid() && state->inserted.index() < state->complex.vertices.size())
        ring(state->complex.position(state->inserted), c.accent, 18);
      if (state->bad_samples > 0 && state->samples && state->worst_sample.valid() &&
          state->worst_sample.index() < state->samples->size())
        ring(state->samples->positions[state->worst_sample.index()], c.bad, 22);
    }
    for (const Pick& pick : {frame.hover, frame.selection}) {
      if (pick.kind == Pick::Kind::tet && pick.id < state->complex.tets.size() &&
          state->complex.tets[pick.id].alive())
        outline(state->complex.positions(TetId(pick.id)), plane, frame.space, color8(c.selection), 2.2f,
                false, marked);
      if (const auto ends = edge_positions(*state, pick))
        marked.segment(frame.space.local(plane.lift(plane.project((*ends)[0]))),
                       frame.space.local(plane.lift(plane.project((*ends)[1]))), color8(c.selection), 2.6f);
      if (pick.kind == Pick::Kind::vertex && pick.id < state->complex.vertices.size())
        ring(state->complex.vertices[pick.id].position, c.selection, 16);
      if (pick.kind == Pick::Kind::sample && state->samples && pick.id < state->samples->size())
        ring(state->samples->positions[pick.id], c.selection, 16);
      if (pick.kind == Pick::Kind::point || pick.kind == Pick::Kind::over_rim)
        ring(pick.point, c.selection, 16);
    }
  }
  MeshBuilder areas;
  if (inputs.xray && frame.view.xray.shown()) {
    const SectionPlane plane = section_plane(frame.view.clip);
    add_attempt(attempt_section(*inputs.xray, inputs.study.get(), plane,
                                {frame.view.invalid_regions, frame.view.octree_cells, frame.colors}),
                plane, frame, areas, marked, marks);
  }
  attempt_.upload(areas);
  sides_.resize(cells.size());
  std::size_t next = 0;
  for (const auto& [label, builder] : cells) {
    sides_[next].style = fill_style(label, state->zero_set.has_rooms(), frame.colors);
    sides_[next++].cells.upload(builder);
  }
  lines_.upload(lines);
  marked_.upload(marked);
  points_.upload(dots);
  samples_.upload(samples);
  marks_.upload(marks);
}

void SectionLayer::draw(Programs& programs, const ViewFrame& frame, ToleranceLayer& tolerance,
                        float background_opacity) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  const bool volume = tolerance.shown(frame.view);
  gl::Program& ground = volume && tolerance.has_detail() ? programs.section_detail : programs.section;
  ground.use();
  if (volume) tolerance.prepare_section(ground, frame);
  ground.set("with_volume", volume ? 1 : 0);
  ground.set("top", frame.colors.ground_top);
  ground.set("bottom", frame.colors.ground_bottom);
  ground.set("rows", frame.rows);
  ground.set("opacity", background_opacity);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  MeshStyle flat;
  flat.opacity = 0.2f;
  flat.back_shade = 1;
  for (Side& side : sides_) {
    flat.walls = side.style;
    side.cells.draw(programs.mesh_flat, flat);
  }
  flat.walls.reset();
  flat.opacity = 1;
  attempt_.draw(programs.mesh_flat, flat);
  lines_.draw(programs.line, 1, 0);
  points_.draw(programs.marker, frame.view.points.opacity);
  samples_.draw(programs.marker, frame.view.samples.opacity);
  marked_.draw(programs.line, 1, 0);
  marks_.draw(programs.marker, 1);
  glDisable(GL_BLEND);
}

} // namespace isoscope
