// The plane and the camera of the 2D section.
#include "scene/section_view.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace isoscope {

constexpr double section_fov = 40;

SectionPlane section_plane(const ClipSettings& clip) {
  const Vec3 n = squared_length(clip.normal) > 0 ? clip.normal : Vec3{1, 0, 0};
  return {clip.point, plane_axes(clip.flipped ? -n : n)};
}

Camera section_camera(const Renderer::SectionView& section, const ClipSettings& clip) {
  const SectionPlane plane = section_plane(clip);
  CameraPose pose;
  pose.orthographic = true;
  pose.fov = section_fov;
  pose.distance = 0.5 * section.height / std::tan(glm::radians(section_fov) / 2);
  pose.target = plane.lift({section.u, section.v});
  const auto column = [](Vec3 a) { return glm::dvec3(a.x, a.y, a.z); };
  const glm::dquat q =
      glm::quat_cast(glm::dmat3(column(plane.axes.u), column(plane.axes.v), column(plane.axes.normal)));
  pose.orientation = {q.x, q.y, q.z, q.w};
  Camera camera;
  camera.set(pose);
  return camera;
}

double section_sample_distance(const StateSnapshot& state) {
  return state.samples ? 0.5 * state.samples->sigma : 0;
}

double section_point_distance(const InputPoints& points) {
  return 0.6 * points.spacing;
}

} // namespace isoscope
