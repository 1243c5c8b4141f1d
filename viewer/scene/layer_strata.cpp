// Where Z ends and where its sheets meet, the rim that it keeps to, and what was cut off it.
#include "scene/layers.h"

#include "mesh/zero_curves.h"

#include <glad/gl.h>

#include <array>

namespace isoscope {
namespace {

constexpr float curve_width = 3.4f, open_width = 2.2f, bridged_width = 1.6f;
constexpr std::uint8_t point_size = 9;

/// Whether a clip of whole cells lets it be seen; always true for one that cuts.
bool shows(const Clip& clip, std::span<const Vec3> corners) {
  return !clip.active() || clip.cuts() || clip.shows_cell(corners);
}

} // namespace

void CurvesLayer::update(const StateSnapshot& state, const Clip& clip, const SceneColors& colors,
                         const SceneSpace& space) {
  const ZeroCurves curves = zero_curves(state.zero_set);
  const auto place = [&](std::uint32_t v) { return state.zero_set.vertices[v].position; };
  LineBuilder lines;
  const Color8 tint = color8(colors.section_zero);
  for (const auto* list : {&curves.border, &curves.triple})
    for (const auto& [a, b] : *list)
      if (shows(clip, std::array{place(a), place(b)}))
        lines.segment(space.local(place(a)), space.local(place(b)), tint, curve_width);
  std::vector<Marker> points;
  for (const std::uint32_t v : curves.points)
    if (shows(clip, std::array{place(v)}))
      points.push_back({space.local(place(v)), color8(colors.selection), MarkerShape::square, point_size});
  lines_.upload(lines);
  points_.upload(points);
}

void CurvesLayer::clear() {
  lines_.upload(LineBuilder());
  points_.upload({});
}

void CurvesLayer::draw(Programs& programs, const ViewFrame& frame) {
  lines_.draw(programs.line, frame.view.curves.opacity, 2e-3f);
  glEnable(GL_PROGRAM_POINT_SIZE);
  points_.draw(programs.marker, frame.view.curves.opacity);
}

void RimLayer::update(const Rim& rim, const Clip& clip, const SceneColors& colors, const SceneSpace& space) {
  LineBuilder lines;
  // Pieces are short: of bridged ones every other makes the dashes.
  bool dash = false;
  const Color8 tint = color8(colors.rim);
  for (const RimPiece& p : rim.pieces()) {
    if (!p.open) dash = !dash;
    if ((p.open || dash) && shows(clip, std::array{p.a, p.b}))
      lines.segment(space.local(p.a), space.local(p.b), tint, p.open ? open_width : bridged_width);
  }
  lines_.upload(lines);
}

void RimLayer::draw(gl::Program& program, const ViewFrame& frame) {
  lines_.draw(program, frame.view.rim.opacity, 1e-3f);
}

void DroppedLayer::update(const StateSnapshot& state, const Clip& clip, const SceneColors& colors,
                          const SceneSpace& space) {
  MeshBuilder builder;
  for (const DroppedFacet& f : dropped_facets(state.complex)) {
    const auto [a, b, c] = state.complex.tet(f.tet).facet(f.facet);
    const Triangle3 p{state.complex.position(a), state.complex.position(c), state.complex.position(b)};
    if (shows(clip, p))
      builder.triangle(space.local(p[0]), space.local(p[1]), space.local(p[2]), color8(colors.rim));
  }
  batch_.upload(builder);
}

void DroppedLayer::draw(gl::Program& program, const ViewFrame& frame) {
  MeshStyle style;
  style.opacity = frame.view.dropped.opacity;
  style.edge_color = glm::vec4(frame.colors.zero_set_edge, 0.5f);
  style.edge_width = frame.pixel_scale;
  style.back_shade = 0.7f;
  batch_.draw(program, style);
}

} // namespace isoscope
