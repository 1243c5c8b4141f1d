// An orbit camera: where it looks from and how the mouse moves it.
#include "scene/camera.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace isoscope {
namespace {

constexpr double transition_seconds = 0.2;
constexpr double zoom_per_step = 0.88;
constexpr double radians_per_pixel_height = 3.6; ///< a drag over the whole height turns about 200 degrees

glm::dvec3 to_glm(Vec3 v) {
  return {v.x, v.y, v.z};
}
Vec3 from_glm(glm::dvec3 v) {
  return {v.x, v.y, v.z};
}
glm::dquat quaternion(const CameraPose& p) {
  return {p.orientation[3], p.orientation[0], p.orientation[1], p.orientation[2]};
}
void store(CameraPose& p, glm::dquat q) {
  q = glm::normalize(q);
  p.orientation = {q.x, q.y, q.z, q.w};
}

/// Depths of the box along the view direction, as seen from the eye.
std::array<double, 2> depth_range(const CameraPose& pose, Vec3 eye, const Box3& box) {
  const Vec3 forward = from_glm(quaternion(pose) * glm::dvec3(0, 0, -1));
  double lo = Box3::inf, hi = -Box3::inf;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p{(corner & 1) ? box.hi.x : box.lo.x, (corner & 2) ? box.hi.y : box.lo.y,
                 (corner & 4) ? box.hi.z : box.lo.z};
    const double depth = dot(p - eye, forward);
    lo = std::min(lo, depth);
    hi = std::max(hi, depth);
  }
  return {lo, hi};
}

} // namespace

CameraPose turned_pose(double yaw, double pitch, double fov) {
  CameraPose pose;
  const double cy = std::cos(yaw / 2), sy = std::sin(yaw / 2), cp = std::cos(pitch / 2),
               sp = std::sin(pitch / 2);
  pose.orientation = {cy * sp, sy * cp, -sy * sp, cy * cp};
  pose.fov = fov;
  return pose;
}

CameraPose first_pose() {
  return turned_pose(0.6, -0.42, 35);
}

double Camera::height_at_target() const {
  return 2 * pose_.distance * std::tan(glm::radians(pose_.fov) / 2);
}

void Camera::set(const CameraPose& pose, bool ease) {
  to_ = pose;
  if (ease) {
    from_ = pose_;
    transition_ = 0;
  } else {
    pose_ = pose;
    transition_ = 1;
  }
}

void Camera::frame_around(Vec3 center, std::span<const Vec3> offsets, bool ease, double aspect) {
  CameraPose pose = goal();
  const glm::dquat to_camera = glm::conjugate(quaternion(pose));
  const double tangent = 0.92 * std::tan(glm::radians(pose.fov) / 2);
  const double sideways = tangent * aspect;
  double distance = 0;
  for (const Vec3 offset : offsets) {
    const glm::dvec3 c = to_camera * to_glm(offset);
    distance = std::max(distance, c.z + std::max(std::abs(c.x) / sideways, std::abs(c.y) / tangent));
  }
  pose.target = center;
  pose.distance = distance > 0 ? distance : 1;
  set(pose, ease);
}

void Camera::frame(std::span<const Vec3> points, bool ease, double aspect) {
  Box3 box;
  for (const Vec3 point : points) box.add(point);
  if (box.empty()) return;
  std::vector<Vec3> offsets;
  offsets.reserve(points.size());
  for (const Vec3 point : points) offsets.push_back(point - box.center());
  frame_around(box.center(), offsets, ease, aspect);
}

void Camera::frame(const Box3& box, bool ease, double aspect) {
  if (box.empty()) return;
  const Vec3 half = 0.5 * box.extent();
  // Models touch the faces of their boxes, seldom the corners: those may come closer to the border, but where
  // the view is narrow, as there is nothing beside it.
  const double inwards = aspect < 1 ? 0.95 : 0.82;
  std::vector<Vec3> offsets;
  for (int corner = 0; corner < 8; ++corner)
    offsets.push_back(inwards * Vec3{(corner & 1) ? half.x : -half.x, (corner & 2) ? half.y : -half.y,
                                     (corner & 4) ? half.z : -half.z});
  for (const double sign : {-1.0, 1.0}) {
    offsets.push_back({sign * half.x, 0, 0});
    offsets.push_back({0, sign * half.y, 0});
    offsets.push_back({0, 0, sign * half.z});
  }
  frame_around(box.center(), offsets, ease, std::min(1.0, aspect));
}

bool Camera::update(double seconds) {
  if (transition_ >= 1) return false;
  transition_ = std::min(1.0, transition_ + seconds / transition_seconds);
  if (transition_ >= 1) {
    pose_ = to_;
    return false;
  }
  const double t = transition_ * transition_ * (3 - 2 * transition_);
  pose_ = to_;
  pose_.target = from_.target + t * (to_.target - from_.target);
  pose_.distance = std::exp(std::log(from_.distance) * (1 - t) + std::log(to_.distance) * t);
  pose_.fov = from_.fov + t * (to_.fov - from_.fov);
  store(pose_, glm::slerp(quaternion(from_), quaternion(to_), t));
  return true;
}

void Camera::orbit(double dx, double dy, double height, Vec3 pivot) {
  transition_ = 1;
  const glm::dquat q = quaternion(pose_);
  const glm::dvec3 up = q * glm::dvec3(0, 1, 0), right = q * glm::dvec3(1, 0, 0);
  const double angle = radians_per_pixel_height / std::max(height, 1.0);
  // Upside down the model must still follow the mouse.
  const double upright = up.y >= 0 ? 1 : -1;
  const glm::dquat turn =
      glm::angleAxis(-dx * angle * upright, glm::dvec3(0, 1, 0)) * glm::angleAxis(-dy * angle, right);
  pose_.target = pivot + from_glm(turn * to_glm(pose_.target - pivot));
  store(pose_, turn * q);
}

void Camera::pan(double dx, double dy, double height, Vec3 pivot) {
  transition_ = 1;
  const glm::dquat q = quaternion(pose_);
  const Vec3 forward = from_glm(q * glm::dvec3(0, 0, -1));
  const double depth = dot(pivot - eye(), forward);
  const bool by_pivot = !pose_.orthographic && depth > 0;
  const double scale = height_at_target() / std::max(height, 1.0) * (by_pivot ? depth / pose_.distance : 1.0);
  pose_.target += from_glm(q * glm::dvec3(-dx * scale, dy * scale, 0));
}

void Camera::zoom(double steps, Vec3 pivot) {
  transition_ = 1;
  const double factor = std::pow(zoom_per_step, steps);
  pose_.distance *= factor;
  pose_.target = pivot + factor * (pose_.target - pivot);
}

void Camera::look_along(int axis, int sign, bool ease) {
  CameraPose pose = transition_ < 1 ? to_ : pose_;
  glm::dvec3 back(0);
  back[axis] = sign >= 0 ? 1 : -1;
  const glm::dvec3 up = axis == 1 ? glm::dvec3(0, 0, -back.y) : glm::dvec3(0, 1, 0);
  store(pose, glm::quat_cast(glm::dmat3(glm::cross(up, back), up, back)));
  set(pose, ease);
}

void Camera::look_from(Vec3 direction, bool ease) {
  if (squared_length(direction) == 0) return;
  CameraPose pose = transition_ < 1 ? to_ : pose_;
  const glm::dvec3 back = glm::normalize(to_glm(direction));
  const glm::dvec3 upright = std::abs(back.y) > 0.98 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(upright, back));
  store(pose, glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back)));
  set(pose, ease);
}

Vec3 Camera::eye() const {
  return pose_.target + from_glm(quaternion(pose_) * glm::dvec3(0, 0, pose_.distance));
}

glm::mat4 Camera::view() const {
  const glm::dmat4 rotation = glm::mat4_cast(glm::conjugate(quaternion(pose_)));
  return glm::mat4(glm::translate(rotation, -to_glm(eye())));
}

Vec3 Camera::to_world(Vec3 direction) const {
  return from_glm(quaternion(pose_) * to_glm(direction));
}

glm::mat4 Camera::projection(double aspect) const {
  std::array<double, 2> depth{0.01 * pose_.distance, 100 * pose_.distance};
  if (!bounds_.empty()) {
    depth = depth_range(pose_, eye(), bounds_);
    const double margin = 0.02 * (depth[1] - depth[0]) + 1e-3 * pose_.distance;
    depth = {depth[0] - margin, depth[1] + margin};
  }
  if (pose_.orthographic) {
    const double h = height_at_target() / 2;
    return glm::mat4(glm::ortho(-h * aspect, h * aspect, -h, h, depth[0], depth[1]));
  }
  const double far_plane = std::max(depth[1], 1e-2 * pose_.distance);
  const double near_plane = std::max({depth[0], 2e-4 * far_plane, 1e-3 * pose_.distance});
  return glm::mat4(
      glm::perspective(glm::radians(pose_.fov), aspect, near_plane, std::max(far_plane, 2 * near_plane)));
}

Camera::Ray Camera::ray(double x, double y, double width, double height) const {
  const double tangent = std::tan(glm::radians(pose_.fov) / 2);
  const double nx = (2 * x / width - 1) * width / height * tangent, ny = (1 - 2 * y / height) * tangent;
  const glm::dquat q = quaternion(pose_);
  if (pose_.orthographic) {
    const glm::dvec3 offset(nx * pose_.distance, ny * pose_.distance, 0);
    return {eye() + from_glm(q * offset), from_glm(q * glm::dvec3(0, 0, -1))};
  }
  return {eye(), normalized(from_glm(q * glm::dvec3(nx, ny, -1)))};
}

} // namespace isoscope
