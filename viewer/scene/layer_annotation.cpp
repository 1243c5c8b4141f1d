// Lines, marks, faces and heat cells of an annotation.
#include "scene/layers.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {
namespace {

glm::vec3 color_of(Tone tone, const SceneColors& c) {
  switch (tone) {
  case Tone::good:
    return c.good;
  case Tone::bad:
    return c.bad;
  case Tone::warning:
    return c.warning;
  case Tone::accent:
    return c.accent;
  case Tone::quiet:
    return c.selection;
  }
  return c.accent;
}

glm::vec3 heat_color(float heat) {
  const float at = std::clamp(heat, 0.0f, 1.0f) * (heat_stops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), heat_stops.size() - 2);
  const float t = at - static_cast<float>(i);
  return (1 - t) * rgb(heat_stops[i]) + t * rgb(heat_stops[i + 1]);
}

void add_cell(const Annotation::Cell& cell, const SceneSpace& space, MeshBuilder& faces,
              std::vector<Marker>& marks) {
  const glm::vec3 middle = space.local(cell.center), color = heat_color(cell.heat);
  const auto half = static_cast<float>(0.5 * cell.size);
  const Color8 tint = color8(color, 0.03f + 0.34f * cell.heat * cell.heat);
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 n(0), u(0), v(0);
      n[axis] = side;
      u[(axis + 1) % 3] = 1;
      v[(axis + 2) % 3] = side;
      const glm::vec3 m = middle + half * n;
      faces.quad({m + half * (-u - v), m + half * (u - v), m + half * (u + v), m + half * (v - u)}, tint);
    }
  // Size says the same as colour.
  marks.push_back({middle, color8(color, 0.95f), MarkerShape::disc,
                   static_cast<std::uint8_t>(4 + 12 * std::sqrt(cell.heat))});
}

} // namespace

void AnnotationLayer::update(const Annotation* annotation, const ViewFrame& frame) {
  MeshBuilder faces;
  LineBuilder lines;
  std::vector<Marker> marks;
  if (annotation) {
    const SceneSpace& space = frame.space;
    for (const auto& f : annotation->faces)
      faces.triangle(space.local(f.corners[0]), space.local(f.corners[1]), space.local(f.corners[2]),
                     color8(color_of(f.tone, frame.colors), f.opacity), 0);
    for (const auto& l : annotation->lines)
      lines.segment(space.local(l.a), space.local(l.b), color8(color_of(l.tone, frame.colors), 0.95f),
                    l.width, l.dashed);
    for (const auto& m : annotation->marks)
      marks.push_back({space.local(m.at), color8(color_of(m.tone, frame.colors)), m.shape, m.diameter});
    for (const auto& c : annotation->cells) add_cell(c, space, faces, marks);
  }
  faces_.upload(faces);
  lines_.upload(lines);
  marks_.upload(marks);
}

void AnnotationLayer::draw(Programs& programs, const ViewFrame&) {
  MeshStyle faces;
  const auto pass = [&](float strength) {
    faces.opacity = strength;
    faces_.draw(programs.mesh_flat, faces);
    lines_.draw(programs.line, strength, 3e-3f);
    marks_.draw(programs.marker, strength);
  };
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_GREATER);
  pass(0.55f);
  glDepthFunc(GL_LEQUAL);
  pass(1.0f);
  glDepthMask(GL_TRUE);
}

} // namespace isoscope
