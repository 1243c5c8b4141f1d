// Cameras of pictures that are not the window's.
#include "scene/picture_view.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace isoscope {

CameraPose fitted(CameraPose pose, double from, double to) {
  if (to < from) pose.fov = glm::degrees(2 * std::atan(std::tan(glm::radians(pose.fov) / 2) * from / to));
  return pose;
}

CameraPose turned(CameraPose pose, double angle) {
  const auto& o = pose.orientation;
  const glm::dquat q =
      glm::normalize(glm::angleAxis(angle, glm::dvec3(0, 1, 0)) * glm::dquat(o[3], o[0], o[1], o[2]));
  pose.orientation = {q.x, q.y, q.z, q.w};
  return pose;
}

} // namespace isoscope
