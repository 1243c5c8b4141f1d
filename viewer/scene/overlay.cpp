// Numbers for what panels draw over the view.
#include "scene/overlay.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

/// A world vector in the camera's frame.
glm::dvec3 in_camera(const Camera& camera, Vec3 v) {
  const auto& q = camera.pose().orientation;
  return glm::conjugate(glm::dquat(q[3], q[0], q[1], q[2])) * glm::dvec3(v.x, v.y, v.z);
}

} // namespace

std::array<ScreenAxis, 3> screen_axes(const Camera& camera) {
  std::array<ScreenAxis, 3> axes;
  for (int i = 0; i < 3; ++i) {
    Vec3 unit;
    unit[i] = 1;
    const glm::dvec3 c = in_camera(camera, unit);
    axes[static_cast<std::size_t>(i)] = {i, c.x, -c.y, c.z};
  }
  std::stable_sort(axes.begin(), axes.end(),
                   [](const ScreenAxis& a, const ScreenAxis& b) { return a.depth < b.depth; });
  return axes;
}

double pixels_per_unit(const Camera& camera, double height) {
  const CameraPose& pose = camera.pose();
  return 0.5 * height / (pose.distance * std::tan(glm::radians(pose.fov) / 2));
}

ScaleBar scale_bar(double pixels_per_delta, double longest) {
  if (!(pixels_per_delta > 0) || !(longest > 0) || !std::isfinite(longest / pixels_per_delta)) return {};
  const double most = longest / pixels_per_delta;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  double deltas = power;
  for (const double factor : {2.0, 5.0})
    if (factor * power <= most) deltas = factor * power;
  return {deltas, deltas * pixels_per_delta};
}

ScreenPoint project(const Camera& camera, Vec3 point, double width, double height) {
  const CameraPose& pose = camera.pose();
  const glm::dvec3 c = in_camera(camera, point - camera.eye());
  const double depth = pose.orthographic ? pose.distance : -c.z;
  if (depth <= 0) return {};
  const double scale = 0.5 * height / (depth * std::tan(glm::radians(pose.fov) / 2));
  return {0.5 * width + c.x * scale, 0.5 * height - c.y * scale, true};
}

} // namespace isoscope
