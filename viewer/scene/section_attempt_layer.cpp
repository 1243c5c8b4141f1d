// Areas as fans with outlines, hatched where they are.
#include "scene/section_attempt_layer.h"

namespace isoscope {

void add_attempt(const AttemptSection& section, const SectionPlane& plane, const ViewFrame& frame,
                 MeshBuilder& faces, LineBuilder& lines, std::vector<Marker>& marks) {
  constexpr double hatch_pixels = 9;
  const auto local = [&](PlanePoint p) { return frame.space.local(plane.lift(p)); };
  const float opacity = frame.view.xray.opacity;
  const double spacing = frame.pixels_per_unit > 0
                             ? hatch_pixels * static_cast<double>(frame.pixel_scale) / frame.pixels_per_unit
                             : 0;
  for (const AttemptSection::Area& area : section.areas) {
    const std::size_t n = area.corners.size();
    for (std::size_t i = 1; i + 1 < n && area.fill > 0; ++i)
      faces.triangle(local(area.corners[0]), local(area.corners[i]), local(area.corners[i + 1]),
                     color8(area.color, area.fill * opacity), 0);
    if (area.hatched)
      for (const auto& [a, b] : hatch_lines(area.corners, spacing))
        lines.segment(local(a), local(b), color8(area.color, 0.55f * opacity), 0.9f);
    for (std::size_t i = 0; i < n; ++i)
      lines.segment(local(area.corners[i]), local(area.corners[(i + 1) % n]),
                    color8(area.color, area.line * opacity),
                    area.role == AttemptSection::Role::cell ? 1.0f : 1.6f);
  }
  for (const AttemptSection::Line& l : section.lines)
    lines.segment(local(l.a), local(l.b), color8(l.color, l.strength * opacity), l.width, l.dashed);
  for (const AttemptSection::Mark& m : section.marks)
    marks.push_back({local(m.at), color8(m.color, m.strength * opacity), m.shape, m.diameter});
}

} // namespace isoscope
