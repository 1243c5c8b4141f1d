// What lies on the face of a cut by a plane.
#include "scene/layer_cut.h"

#include "scene/section_geometry.h"
#include "scene/section_view.h"

#include <algorithm>

namespace isoscope {

bool CutLayer::shown(const ViewFrame& frame) {
  const ClipSettings& clip = frame.view.clip;
  if (clip.shape != ClipSettings::Shape::plane || clip.mode != ClipSettings::Mode::cut) return false;
  return dot(frame.eye - clip.point, clip.normal) * (clip.flipped ? -1 : 1) > 0;
}

void CutLayer::update(const std::shared_ptr<const StateSnapshot>& kept_state, double aside,
                      const ViewFrame& frame) {
  const ViewSettings& view = frame.view;
  const Made wanted{kept_state.get(), view, frame.space};
  if (made_ == wanted) return;
  made_ = wanted;
  lines_.upload({});
  samples_.upload({});
  if (!kept_state) return;
  const StateSnapshot& state = *kept_state;
  const SceneColors& c = frame.colors;
  const SectionPlane plane = section_plane(view.clip);
  const SectionGeometry geometry =
      section_geometry(state, plane, {view.tets.box, section_sample_distance(state)});
  const Vec3 kept = (view.clip.flipped ? aside : -aside) * view.clip.normal;
  const auto local = [&](PlanePoint p) { return frame.space.local(plane.lift(p) + kept); };
  LineBuilder lines;
  if (view.zero_set.shown())
    for (const SectionGeometry::Segment& s : geometry.zero_set)
      lines.segment(local(s.a), local(s.b), color8(c.section_zero), 2.4f);
  std::vector<Marker> samples;
  const bool classified = state.classifies();
  if (view.samples.shown())
    for (const SectionGeometry::Sample& s : geometry.samples) {
      if (!(s.bad ? view.bad_samples : view.good_samples).shown()) continue;
      const glm::vec3 color = s.bad ? c.bad : classified ? c.good : c.tetrahedron;
      const auto size =
          static_cast<std::uint8_t>(std::clamp(view.sample_size + (s.bad ? 2.0f : 0.0f), 3.0f, 30.0f));
      samples.push_back({local(s.at), color8(color), s.bad ? MarkerShape::cross : MarkerShape::disc, size});
    }
  lines_.upload(lines);
  samples_.upload(samples);
}

void CutLayer::draw(Programs& programs, const ViewFrame& frame) {
  lines_.draw(programs.line, frame.view.zero_set.opacity, 0);
  samples_.draw(programs.marker, frame.view.samples.opacity);
}

} // namespace isoscope
