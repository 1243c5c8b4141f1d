// The camera: fixed points of its motions, framing, transitions, views as JSON.
#include "scene/camera.h"
#include "scene/outline.h"
#include "scene/overlay.h"
#include "scene/renderer.h"

#include <doctest/doctest.h>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace isoscope;

namespace {

constexpr double width = 640, height = 480;

Camera tilted(bool orthographic = false) {
  CameraPose pose;
  pose.target = {0.3, -0.2, 0.5};
  pose.distance = 4;
  pose.orientation = {0.1, 0.7, -0.1, 0.7};
  pose.orthographic = orthographic;
  Camera camera;
  camera.set(pose);
  return camera;
}

/// A point under a screen position, at some depth along the ray.
Vec3 under(const Camera& camera, double x, double y, double t) {
  const Camera::Ray ray = camera.ray(x, y, width, height);
  return ray.origin + t * ray.direction;
}

void check_at(const Camera& camera, Vec3 p, double x, double y) {
  const ScreenPoint at = project(camera, p, width, height);
  CHECK(at.visible);
  CHECK(at.x == doctest::Approx(x).epsilon(1e-9));
  CHECK(at.y == doctest::Approx(y).epsilon(1e-9));
}

} // namespace

TEST_CASE("rays and projections are inverse, with the matrices too") {
  for (const bool orthographic : {false, true}) {
    const Camera camera = tilted(orthographic);
    const Vec3 p = under(camera, 120, 333, 3.5);
    check_at(camera, p, 120, 333);
    const glm::vec4 clip = camera.projection(width / height) * camera.view() * glm::vec4(p.x, p.y, p.z, 1);
    CHECK((0.5 + 0.5 * clip.x / clip.w) * width == doctest::Approx(120).epsilon(1e-4));
    CHECK((0.5 - 0.5 * clip.y / clip.w) * height == doctest::Approx(333).epsilon(1e-4));
  }
}

TEST_CASE("zooming keeps the point under the cursor where it is") {
  for (const bool orthographic : {false, true}) {
    Camera camera = tilted(orthographic);
    const Vec3 p = under(camera, 500, 77, 2.9);
    for (const double steps : {1.0, 3.0, -5.0, 0.25}) {
      const double before = camera.pose().distance;
      camera.zoom(steps, p);
      CHECK((steps > 0) == (camera.pose().distance < before));
      check_at(camera, p, 500, 77);
    }
  }
}

TEST_CASE("orbiting keeps the pivot where it is on the screen and its distance") {
  for (const bool orthographic : {false, true}) {
    Camera camera = tilted(orthographic);
    const Vec3 pivot = under(camera, 200, 300, 3.1);
    const double away = distance(camera.eye(), pivot);
    for (const auto& [dx, dy] : {std::pair{40.0, 0.0}, std::pair{0.0, -90.0}, std::pair{-33.0, 210.0}}) {
      camera.orbit(dx, dy, height, pivot);
      check_at(camera, pivot, 200, 300);
      CHECK(distance(camera.eye(), pivot) == doctest::Approx(away));
    }
    double norm = 0;
    for (const double q : camera.pose().orientation) norm += q * q;
    CHECK(norm == doctest::Approx(1).epsilon(1e-14));
  }
}

TEST_CASE("panning carries the pivot along with the cursor") {
  for (const bool orthographic : {false, true}) {
    Camera camera = tilted(orthographic);
    const Vec3 pivot = under(camera, 320, 200, 5.5);
    camera.pan(37, -52, height, pivot);
    check_at(camera, pivot, 357, 148);
  }
}

TEST_CASE("framing shows the middles of all faces and keeps the direction") {
  Box3 box;
  box.add(Vec3{-1, 2, 10});
  box.add(Vec3{5, 3, 12});
  Camera camera = tilted();
  const auto orientation = camera.pose().orientation;
  camera.frame(box, false);
  CHECK(camera.pose().orientation == orientation);
  CHECK(camera.pose().target == box.center());
  double most = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-0.5, 0.5}) {
      Vec3 p = box.center();
      p[axis] += sign * box.extent()[axis];
      const ScreenPoint at = project(camera, p, 480, 480);
      CHECK(at.x >= 0);
      CHECK(at.x <= 480);
      CHECK(at.y >= 0);
      CHECK(at.y <= 480);
      most = std::max({most, std::abs(at.x - 240), std::abs(at.y - 240)});
    }
  CHECK(most > 120); // it fills a good part of the view
  camera.frame(Box3(), false);
  CHECK(camera.pose().target == box.center());
}

TEST_CASE("points that are framed are all in sight, and one touches the border of the view") {
  TriangleSoup ball;
  for (int i = 0; i < 40; ++i)
    for (int j = 1; j < 20; ++j) {
      const double u = 0.05 * std::numbers::pi * i, v = 0.05 * std::numbers::pi * j;
      ball.points.push_back({3 + std::cos(u) * std::sin(v), std::sin(u) * std::sin(v), std::cos(v)});
    }
  const std::vector<Vec3> reach = outline(ball, 0.5);
  CHECK(outline(TriangleSoup(), 0.5).empty());
  for (const Vec3 p : reach) CHECK(distance(p, Vec3{3, 0, 0}) <= 1.5 + 1e-9);
  for (const double aspect : {0.4, 1.0, 1.8}) {
    Camera camera = tilted();
    camera.frame(reach, false, aspect);
    const double wide = 500 * aspect;
    double most = 0;
    for (const Vec3 p : reach) {
      const ScreenPoint at = project(camera, p, wide, 500);
      most = std::max({most, std::abs(at.x - wide / 2) / (wide / 2), std::abs(at.y - 250) / 250});
    }
    CHECK(most < 1);
    CHECK(most > 0.85); // a little room is left
  }
}

TEST_CASE("transitions take 200 ms, end exactly and give way to the mouse") {
  Camera camera = tilted();
  CameraPose goal;
  goal.target = {9, 8, 7};
  goal.distance = 40;
  camera.set(goal, true);
  CHECK_FALSE(camera.pose() == goal);
  CHECK(camera.update(0.1));
  CHECK(camera.pose().distance == doctest::Approx(std::sqrt(4.0 * 40.0)));
  CHECK_FALSE(camera.update(0.11));
  CHECK(camera.pose() == goal);
  camera.set(tilted().pose(), true);
  camera.zoom(1, {0, 0, 0});
  CHECK_FALSE(camera.update(0.05));
}

TEST_CASE("looking along an axis puts the eye on its side") {
  for (int axis = 0; axis < 3; ++axis)
    for (const int sign : {-1, 1}) {
      Camera camera = tilted();
      camera.look_along(axis, sign, false);
      const Vec3 away = camera.eye() - camera.pose().target;
      CHECK(away[axis] * sign == doctest::Approx(4));
      CHECK(length(away) == doctest::Approx(4));
    }
}

TEST_CASE("a view survives JSON bit by bit") {
  CameraPose pose;
  pose.target = {1.0 / 3, -1e-17, 12345.678901234567};
  pose.distance = 0.1 + 0.2;
  const double norm = std::sqrt(0.01 + 0.04 + 0.09 + 0.16);
  pose.orientation = {0.1 / norm, 0.2 / norm, 0.3 / norm, 0.4 / norm};
  pose.fov = 33.3;
  pose.orthographic = true;
  const auto back = camera_from_json(to_json(pose));
  REQUIRE(back);
  CHECK(*back == pose);
  for (const char* text :
       {"", "{}", "[1,2]", "nonsense", R"({"target":[0,0,0],"distance":-1,"orientation":[0,0,0,1],"fov":40})",
        R"({"target":[0,0],"distance":1,"orientation":[0,0,0,1],"fov":40})",
        R"({"target":[0,0,0],"distance":1,"orientation":[0,0,0,0],"fov":40})",
        R"({"target":[0,0,0],"distance":1,"orientation":[0,0,0,1],"fov":400})"})
    CHECK_FALSE(camera_from_json(text));
}

TEST_CASE("plane axes are right-handed and upright") {
  for (const Vec3 n : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}, Vec3{0.3, -0.4, 0.2}, Vec3{0, 0, -2}}) {
    const PlaneAxes axes = plane_axes(n);
    CHECK(length(cross(axes.u, axes.v) - axes.normal) < 1e-12);
    CHECK(dot(axes.normal, n) == doctest::Approx(length(n)));
    CHECK(axes.v.y >= 0);
  }
}

TEST_CASE("the scale bar is 1, 2 or 5 times a power of ten of delta") {
  CHECK(scale_bar(10, 120).deltas == doctest::Approx(10));
  CHECK(scale_bar(10, 220).deltas == doctest::Approx(20));
  CHECK(scale_bar(300, 120).deltas == doctest::Approx(0.2));
  CHECK(scale_bar(300, 120).pixels == doctest::Approx(60));
  CHECK(scale_bar(0, 120).pixels == 0);
}

TEST_CASE("the axes of the gizmo come farthest first") {
  Camera camera;
  const auto axes = screen_axes(camera); // looking down the z axis
  CHECK(axes[2].axis == 2);
  CHECK(axes[2].depth == doctest::Approx(1));
  for (const ScreenAxis& a : axes) {
    if (a.axis == 0) CHECK(a.x == doctest::Approx(1));
    if (a.axis == 1) CHECK(a.y == doctest::Approx(-1));
  }
}
