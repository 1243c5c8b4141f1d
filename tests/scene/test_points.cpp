// Points of the input: what they count for, how they are picked, and what the section shows of them.
#include "scene/input_points.h"
#include "scene/overlay.h"
#include "scene/picking.h"
#include "scene/section_svg.h"
#include "scene/section_view.h"

#include "tolerance/weighted_points.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace isoscope;

namespace {

constexpr int width = 400, height = 300;

/// Points (0, 0, 0), (1, 0, 0), (0, 0, -2) of weights 0 and ¼, and a dropped one at (-1, 0, 0); δ = 1.
Scene scene_of_points() {
  auto soup = std::make_shared<TriangleSoup>();
  soup->points = {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, -2}};
  auto field = std::make_shared<PointField>();
  field->points = soup;
  field->neighbors = 1;
  field->point = {0, 1, 3};
  Scene scene;
  scene.input = soup;
  scene.points = field;
  scene.field = std::make_shared<const WeightedPointIndex>(
      std::vector<WeightedPoint>{{{0, 0, 0}, 0}, {{1, 0, 0}, 0.25}, {{0, 0, -2}, 0}}, 3.0);
  scene.delta = 1;
  scene.longest_edge = 2;
  return scene;
}

Camera front() {
  Camera camera;
  CameraPose pose;
  pose.distance = 10;
  camera.set(pose);
  return camera;
}

PickAt at(const Camera& camera, Vec3 p) {
  const ScreenPoint s = project(camera, p, width, height);
  return {s.x, s.y, width, height};
}

} // namespace

TEST_CASE("points have weights in δ, the dropped ones none") {
  const auto points = input_points(scene_of_points());
  REQUIRE(points);
  REQUIRE(points->size() == 4);
  CHECK(points->weights[0] == 0);
  CHECK(points->weights[1] == doctest::Approx(0.5));
  CHECK(points->dropped(2));
  CHECK_FALSE(points->dropped(3));
  CHECK(points->spacing == doctest::Approx(1));
  Scene other;
  CHECK(input_points(other) == nullptr);
}

TEST_CASE("the ramp ascends in brightness on dark ground and descends on light") {
  const auto light = [](glm::vec3 c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; };
  for (int i = 0; i < 10; ++i) {
    const float a = static_cast<float>(i) / 10, b = static_cast<float>(i + 1) / 10;
    CHECK(light(weight_color(ThemeKind::dark, a)) < light(weight_color(ThemeKind::dark, b)));
    CHECK(light(weight_color(ThemeKind::paper, a)) > light(weight_color(ThemeKind::paper, b)));
  }
}

TEST_CASE("points are picked, near ones first, where layer, kinds and clip let them") {
  const Scene scene = scene_of_points();
  const auto points = input_points(scene);
  const StateSnapshot state;
  const PickScene data{&state, scene.input.get(), nullptr, points.get()};
  const Camera camera = front();
  ViewSettings view;
  const auto pick = [&](Vec3 p, PickKinds kinds, int deeper = 0) {
    return pick_scene(data, camera, view, at(camera, p), kinds, deeper);
  };
  CHECK(pick({1, 0, 0}, PickKinds::all).kind == Pick::Kind::point);
  CHECK(pick({1, 0, 0}, PickKinds::all).id == 1);
  CHECK(pick({0, 0, 0}, PickKinds::points).id == 0);
  CHECK(pick({0, 0, 0}, PickKinds::points, 1).id == 3);
  CHECK(pick({-1, 0, 0}, PickKinds::points).id == 2);
  CHECK(pick({1, 0, 0}, PickKinds::samples).kind == Pick::Kind::none);
  CHECK(pick({0.5, 0.5, 0}, PickKinds::points).kind == Pick::Kind::none);
  view.clip.shape = ClipSettings::Shape::plane; // keeps x <= 0.5
  view.clip.point = {0.5, 0, 0};
  CHECK(pick({1, 0, 0}, PickKinds::points).kind == Pick::Kind::none);
  CHECK(pick({0, 0, 0}, PickKinds::points).id == 0);
  view.points.visible = false;
  CHECK(pick({0, 0, 0}, PickKinds::points).kind == Pick::Kind::none);
}

TEST_CASE("the section picks and draws the points near to its plane") {
  const Scene scene = scene_of_points();
  const auto points = input_points(scene);
  const StateSnapshot state;
  ViewSettings view;
  view.clip.normal = {0, 0, 1};
  const Renderer::SectionView section{0, 0, 4};
  const SectionPlane plane = section_plane(view.clip);
  const auto pick = [&](Vec3 p) {
    const PlanePoint q = plane.project(p);
    const double unit = section.height / height;
    return pick_section_scene(state, points.get(), section, view,
                              {width / 2.0 + q.u / unit, height / 2.0 - q.v / unit, width, height},
                              PickKinds::all);
  };
  CHECK(pick({1, 0, 0}).id == 1);
  CHECK(pick({1, 0, 0}).kind == Pick::Kind::point);
  CHECK(pick({0, 0, -2}).id == 0);
  CHECK(pick({0, 1, 0}).kind == Pick::Kind::none);

  SectionFigure figure;
  figure.section = section;
  figure.view = view;
  figure.delta = 1;
  figure.points = points;
  const std::string svg = section_svg(state, nullptr, figure);
  const std::size_t kept = svg.find("<g id=\"points-by-weight\""),
                    dropped = svg.find("<g id=\"points-dropped\"");
  REQUIRE(kept != std::string::npos);
  REQUIRE(dropped != std::string::npos);
  const auto count = [&](std::size_t from, std::size_t to, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t i = svg.find(what, from); i < to; i = svg.find(what, i + 1)) ++n;
    return n;
  };
  CHECK(count(kept, dropped, "<circle") == 2);
  CHECK(count(dropped, svg.find("</g>", dropped), "class=\"dropped\"") == 1);
}
