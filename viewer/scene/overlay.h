// Numbers for what panels draw over the view: the axes' directions on the screen and the scale bar.
#pragma once

#include "scene/camera.h"

#include <array>

namespace isoscope {

/// One axis as the gizmo shows it.
struct ScreenAxis {
  int axis = 0;        ///< 0, 1, 2
  double x = 0, y = 0; ///< of the unit vector on the screen, y downwards
  double depth = 0;    ///< in [-1, 1], positive towards the viewer
};

/// The three axes, farthest first, so that drawing them in order is right.
std::array<ScreenAxis, 3> screen_axes(const Camera& camera);

/// Pixels that one scene unit covers at the camera's target in a view of that height.
double pixels_per_unit(const Camera& camera, double height);

/// A bar of 1, 2 or 5 times a power of ten of δ that is at most `longest` pixels long.
struct ScaleBar {
  double deltas = 1; ///< its length in δ
  double pixels = 0;
};
ScaleBar scale_bar(double pixels_per_delta, double longest);

/// Where a point appears, in pixels from the top left; `visible` is false behind the viewer.
struct ScreenPoint {
  double x = 0, y = 0;
  bool visible = false;
};
ScreenPoint project(const Camera& camera, Vec3 point, double width, double height);

} // namespace isoscope
