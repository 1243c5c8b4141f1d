// An orbit camera: where it looks from, how the mouse moves it, how a view travels as JSON.
#pragma once

#include "base/geometry.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>

#include <optional>
#include <span>
#include <string>

namespace isoscope {

/// Position by target, distance and orientation; perspective or orthographic. Angles in degrees, lengths in
/// scene units.
struct CameraPose {
  Vec3 target;
  double distance = 3;
  std::array<double, 4> orientation{0, 0, 0, 1}; ///< unit quaternion x, y, z, w: camera to world
  double fov = 40;                               ///< vertical, degrees
  bool orthographic = false;
  friend bool operator==(const CameraPose&, const CameraPose&) = default;
};

/// Around the origin, turned by so many radians about y, and before that about x: a negative `pitch` looks
/// down.
CameraPose turned_pose(double yaw, double pitch, double fov);
/// From above right in front, where depth is seen at once: how a model is first looked at.
CameraPose first_pose();

class Camera {
 public:
  const CameraPose& pose() const { return pose_; }
  /// Scene units over the view's height, where it looks.
  double height_at_target() const;
  /// Where a transition leads; the pose itself at rest.
  const CameraPose& goal() const { return transition_ < 1 ? to_ : pose_; }
  /// Jumps, or eases over 200 ms of update() time when `ease`.
  void set(const CameraPose& pose, bool ease = false);
  /// True once a person or a script has set the view: loading a model must not move it then.
  bool was_set() const { return was_set_; }
  void mark_set() { was_set_ = true; }
  /// Whoever set it has left: it is the program's own again, and shows the whole model.
  void release() { was_set_ = false; }

  /// Looks at the box from the present direction so that it fills a view of that aspect, width to height.
  void frame(const Box3& box, bool ease, double aspect = 1);
  /// The same of points, with the middle of their box in the middle: none of them lies outside.
  void frame(std::span<const Vec3> points, bool ease, double aspect = 1);
  /// Advances a transition; true while it is under way.
  bool update(double seconds);

  /// Mouse motions in pixels, in a viewport of the given size. `pivot`: the point under the cursor when the
  /// drag began.
  void orbit(double dx, double dy, double height, Vec3 pivot);
  void pan(double dx, double dy, double height, Vec3 pivot);
  /// Wheel steps; keeps the point under the cursor where it is.
  void zoom(double steps, Vec3 pivot);
  /// Looks along an axis: 0, 1, 2 and sign.
  void look_along(int axis, int sign, bool ease);
  /// Looks from a direction, y upwards where it can be.
  void look_from(Vec3 direction, bool ease);

  glm::mat4 view() const;
  glm::mat4 projection(double aspect) const;
  Vec3 eye() const;
  /// A direction of the picture (x right, y up, z towards the eye) in the scene.
  Vec3 to_world(Vec3 direction) const;
  /// World ray through a viewport position; pixels, origin top left.
  struct Ray {
    Vec3 origin, direction;
  };
  Ray ray(double x, double y, double width, double height) const;
  void set_scene_bounds(const Box3& box) { bounds_ = box; } ///< for near and far planes

 private:
  void frame_around(Vec3 center, std::span<const Vec3> offsets, bool ease, double aspect);

  CameraPose pose_, from_, to_;
  double transition_ = 1; ///< in [0, 1], 1 at rest
  bool was_set_ = false;
  Box3 bounds_;
};

/// The pose as one line of JSON and back; nullopt when the text is no pose.
std::string to_json(const CameraPose& pose);
std::optional<CameraPose> camera_from_json(const std::string& text);

} // namespace isoscope
