// The renderer in a hidden window: facts about pixels, and small reference pictures.
#include "scene/fabricate.h"
#include "scene/picture.h"
#include "scene/renderer.h"
#include "scene/volume_look.h"

#include "input/gallery.h"
#include "tolerance/weighted_points.h"

#include <GLFW/glfw3.h>
#include <doctest/doctest.h>
#include <glad/gl.h>

#include <algorithm>
#include <cmath>

using namespace isoscope;
using testing::Picture;

namespace {

/// A hidden window with an OpenGL 4.1 core context for as long as it lives; needs a display.
class GlContext {
 public:
  GlContext() {
    if (!glfwInit()) return;
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    window_ = glfwCreateWindow(64, 64, "test", nullptr, nullptr);
    if (!window_) return;
    glfwMakeContextCurrent(window_);
    ready_ = gladLoadGL(glfwGetProcAddress) != 0;
  }
  ~GlContext() { glfwTerminate(); }
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  bool ready() const { return ready_; }

 private:
  GLFWwindow* window_ = nullptr;
  bool ready_ = false;
};

/// Everything that lives for the whole program: the context, the renderer, a sphere under refinement.
struct Studio {
  GlContext context;
  testing::Fabricated sphere = testing::fabricate_ball(*make_gallery_model("sphere"), 6, 1500, 60, 48);
  std::unique_ptr<Renderer> renderer;
  Camera camera;
  FrameRequest request;

  Studio() {
    REQUIRE(context.ready());
    auto created = Renderer::create();
    REQUIRE(created);
    renderer = std::move(*created);
    renderer->set_scene(sphere.scene);
    renderer->set_grid(sphere.grid);
    renderer->set_state(sphere.state);
    camera.frame(renderer->bounds(), false);
    request.width = 160;
    request.height = 140;
  }
  Picture draw(const ViewSettings& view) {
    return testing::take(*renderer, renderer->render(camera, view, request));
  }
  double delta_pixels() const {
    const double tangent = std::tan(camera.pose().fov * 3.14159265358979 / 360);
    return sphere.scene->delta * 0.5 * request.height / (camera.pose().distance * tangent);
  }
};

Studio& studio() {
  static Studio made;
  return made;
}

ViewSettings nothing() {
  ViewSettings view;
  view.outer.visible = view.inner.visible = view.samples.visible = view.tetrahedra.visible = false;
  view.zero_set.visible = view.highlight.visible = false;
  return view;
}

bool green(const Picture::Color& c) {
  return c[1] > c[0] + 60 && c[1] > c[2];
}
bool orange(const Picture::Color& c) {
  return c[0] > c[2] + 90 && c[0] > c[1] + 60;
}
bool bluish(const Picture::Color& c) {
  return c[2] > c[0] + 25 && c[1] > c[0] + 10;
}

} // namespace

TEST_CASE("without a context there is a clear error") {
  const auto renderer = Renderer::create();
  REQUIRE_FALSE(renderer);
  CHECK(renderer.error().code == ErrorCode::device);
  CHECK_FALSE(renderer.error().line().empty());
}

TEST_CASE("an empty view shows the gradient, or nothing when transparent") {
  Studio& s = studio();
  const Picture ground = s.draw(nothing());
  CHECK(ground.width == 160);
  CHECK(ground.height == 140);
  CHECK(ground.at(80, 2)[0] > ground.at(80, 137)[0]);
  CHECK(ground.at(80, 70)[3] == 255);
  s.request.transparent_background = true;
  CHECK(s.draw(nothing()).at(80, 70)[3] == 0);
  ViewSettings view = nothing();
  view.zero_set.visible = true;
  CHECK(s.draw(view).at(80, 70)[3] == 255);
  // Translucent things keep their own colour, whatever they will be laid over.
  view = nothing();
  view.outer.visible = true;
  const Picture::Color outer = s.draw(view).at(80, 70);
  CHECK(outer[3] > 40);
  CHECK(outer[3] < 220);
  CHECK(bluish(outer));
  CHECK(outer[2] > 110);
  s.request.transparent_background = false;
}

TEST_CASE("the outer boundary reaches beyond the inner one by the thickness of Ω") {
  Studio& s = studio();
  const Picture ground = s.draw(nothing());
  const auto extent = [&](const ViewSettings& view) {
    const Picture p = s.draw(view);
    int first = 80;
    for (int x = 80; x >= 0; --x) {
      int change = 0;
      for (std::size_t i = 0; i < 3; ++i) change += std::abs(p.at(x, 70)[i] - ground.at(x, 70)[i]);
      if (change > 6) first = x;
    }
    return 80 - first;
  };
  ViewSettings outer = nothing(), inner = nothing();
  outer.outer.visible = true;
  inner.inner.visible = true;
  const double thickness = extent(outer) - extent(inner);
  CHECK(thickness == doctest::Approx(2 * s.delta_pixels()).epsilon(0.25));
  CHECK(bluish(s.draw(outer).at(80, 70)));
}

TEST_CASE("an opaque zero set hides the inner boundary behind it") {
  Studio& s = studio();
  // Once all samples are good, Z lies between the boundaries.
  const auto refined = testing::fabricate_ball(*make_gallery_model("sphere"), 6, 1500, 2000, 8).state;
  REQUIRE(refined->bad_samples == 0);
  s.renderer->set_state(refined);
  ViewSettings view = nothing();
  view.zero_set.visible = true;
  view.zero_set_edges = false;
  const Picture plain = s.draw(view);
  view.inner.visible = true;
  const Picture with_inner = s.draw(view);
  CHECK(testing::difference(plain, with_inner) < 3);
  view.outer.visible = true;
  CHECK(testing::difference(plain, s.draw(view)) > 3);
  view.zero_set.opacity = 0.4f;
  view.outer.visible = false;
  CHECK(testing::difference(s.draw(view), with_inner) > 3);
  s.renderer->set_state(s.sphere.state);
}

TEST_CASE("the clip removes what is on its positive side, in every layer") {
  Studio& s = studio();
  const Picture ground = s.draw(nothing());
  for (int layer = 0; layer < 5; ++layer) {
    ViewSettings view = nothing();
    if (layer == 0) view.outer.visible = view.inner.visible = true;
    if (layer == 1) view.samples.visible = true;
    if (layer == 2) view.zero_set.visible = true;
    if (layer == 3) view.tetrahedra.visible = view.tets.all = true;
    if (layer == 4) view.input.visible = true;
    view.clip.shape = ClipSettings::Shape::plane;
    view.clip.normal = {1, 0, 0};
    view.clip.point = s.sphere.scene->input->bounds().center();
    for (const bool flipped : {false, true}) {
      view.clip.flipped = flipped;
      const Picture p = s.draw(view);
      std::array<double, 2> change{0, 0};
      for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
          if (std::abs(x - 80) > 6)
            change[x < 80 ? 0 : 1] +=
                std::abs(p.at(x, y)[0] - ground.at(x, y)[0]) + std::abs(p.at(x, y)[2] - ground.at(x, y)[2]);
      CAPTURE(layer);
      CHECK(change[flipped ? 1 : 0] > 10000);
      CHECK(change[flipped ? 0 : 1] < 200);
    }
  }
}

TEST_CASE("samples are green where good and orange where bad, and can be hidden by class") {
  Studio& s = studio();
  REQUIRE(s.sphere.state->bad_samples > 0);
  ViewSettings view = nothing();
  view.samples.visible = true;
  const Picture both = s.draw(view);
  CHECK(both.count(green) > 500);
  CHECK(both.count(orange) > 5);
  view.bad_samples.visible = false;
  CHECK(s.draw(view).count(orange) == 0);
  view.bad_samples.visible = true;
  view.good_samples.visible = false;
  const Picture bad = s.draw(view);
  CHECK(bad.count(green) == 0);
  CHECK(bad.count(orange) > 5);
}

TEST_CASE("a selected tetrahedron is outlined, through other things too") {
  Studio& s = studio();
  ViewSettings view = nothing();
  view.zero_set.visible = true;
  const Picture before = s.draw(view);
  s.request.selection = {Pick::Kind::tet, s.sphere.state->zero_set.polygons.front().tet.value, {}};
  const Picture after = s.draw(view);
  s.request.selection = {};
  CHECK(testing::difference(before, after) > 0.05);
}

TEST_CASE("moving frames show the same thing") {
  Studio& s = studio();
  const Picture rest = s.draw(ViewSettings());
  CHECK(rest.count([](const Picture::Color& c) { return c[3] < 250; }) == 0);
  s.request.quality = Quality::moving;
  const auto frame = s.renderer->render(s.camera, ViewSettings(), s.request);
  s.request.quality = Quality::rest;
  const Picture moving = testing::take(*s.renderer, frame);
  CHECK(moving.width <= rest.width);
  CHECK(moving.count([](const Picture::Color& c) { return c[3] < 250; }) == 0);
  double sum = 0;
  for (int y = 0; y < rest.height; ++y)
    for (int x = 0; x < rest.width; ++x) {
      const auto a = rest.at(x, y),
                 b = moving.at(x * moving.width / rest.width, y * moving.height / rest.height);
      for (std::size_t i = 0; i < 3; ++i) sum += std::abs(a[i] - b[i]);
    }
  CHECK(sum / (3 * rest.width * rest.height) < 14);
}

TEST_CASE("reference pictures") {
  Studio& s = studio();
  constexpr double tolerance = 4;
  ViewSettings view;
  view.tets.violate_1 = true;
  CHECK(testing::compare_with_reference(s.draw(view), "scene_dark") < tolerance);
  view.theme = ThemeKind::paper;
  view.samples.visible = view.tetrahedra.visible = view.highlight.visible = false;
  view.clip.shape = ClipSettings::Shape::plane;
  view.clip.normal = normalized(Vec3{0.3, 0.2, 1});
  view.clip.point = s.sphere.scene->input->bounds().center();
  CHECK(testing::compare_with_reference(s.draw(view), "cut_paper") < tolerance);
  ViewSettings section;
  section.theme = ThemeKind::paper;
  section.gamma.visible = true;
  section.clip.normal = {0, 0, 1};
  section.clip.point = view.clip.point;
  const Renderer::SectionView plane{0, 0, 1.2 * s.sphere.scene->longest_edge};
  const auto frame = s.renderer->render_section(plane, section, s.request);
  CHECK(testing::compare_with_reference(testing::take(*s.renderer, frame), "section_paper") < tolerance);
}

TEST_CASE("points are drawn in the colour of their weight, dropped ones as crosses") {
  Studio& s = studio();
  auto soup = std::make_shared<TriangleSoup>();
  soup->points = {{-0.5, 0, 0}, {0, 0, 0}, {0.5, 0, 0}};
  auto field = std::make_shared<PointField>();
  field->points = soup;
  field->neighbors = 1;
  field->point = {0, 1};
  auto scene = std::make_shared<Scene>();
  scene->input = soup;
  scene->points = field;
  scene->field = std::make_shared<const WeightedPointIndex>(
      std::vector<WeightedPoint>{{{-0.5, 0, 0}, 0}, {{0, 0, 0}, 0.0099}}, 0.5);
  scene->delta = 0.1;
  s.renderer->set_scene(scene);
  s.renderer->set_grid(nullptr);
  ViewSettings view = nothing();
  view.sample_size = 20;
  CameraPose pose;
  pose.distance = 3;
  Camera camera;
  camera.set(pose);
  const auto draw = [&] { return testing::take(*s.renderer, s.renderer->render(camera, view, s.request)); };
  const auto yellow = [](const Picture::Color& c) { return c[0] > c[2] + 90 && c[1] > c[2] + 90; };
  const auto reddish = [](const Picture::Color& c) { return c[0] > c[1] + 40 && c[0] > c[2] + 60; };
  const Picture all = draw();
  CHECK(all.count(bluish) > 40);   // weight 0
  CHECK(all.count(yellow) > 40);   // weight near δ
  CHECK(all.count(reddish) > 15);  // dropped
  CHECK(all.count(reddish) < 600); // a disc of that size has 960
  view.theme = ThemeKind::paper;
  CHECK(testing::difference(draw(), all) > 30);
  view.theme = ThemeKind::dark;
  view.points.visible = false;
  CHECK(draw().count(yellow) == 0);
  s.renderer->set_scene(s.sphere.scene);
  s.renderer->set_grid(s.sphere.grid);
  view.points.visible = true;
  CHECK(s.draw(view).count(yellow) == 0); // of another scene
}

TEST_CASE("Ω is drawn at another level at once") {
  Studio& s = studio();
  const Picture ground = s.draw(nothing());
  const auto covered = [&](float level) {
    ViewSettings view = nothing();
    view.outer = {true, 1.0f};
    view.level = level;
    const Picture p = s.draw(view);
    std::size_t n = 0;
    for (int y = 0; y < p.height; ++y)
      for (int x = 0; x < p.width; ++x) n += p.at(x, y)[2] > ground.at(x, y)[2] + 20 ? 1u : 0u;
    return static_cast<double>(n);
  };
  const double radius = 0.5 * s.sphere.scene->longest_edge / s.sphere.scene->delta; // in δ
  for (const float level : {0.5f, 1.5f}) {
    const double wanted = std::pow((radius + static_cast<double>(level)) / (radius + 1), 2);
    CHECK(covered(level) / covered(1) == doctest::Approx(wanted).epsilon(0.03));
  }
}

TEST_CASE("frames of a resting picture are averaged into a smoother one of the same thing") {
  Studio& s = studio();
  ViewSettings view = nothing();
  view.zero_set.visible = true;
  view.outer.visible = view.inner.visible = true;
  const Picture first = s.draw(view);
  Picture last = first;
  for (int still = 1; still < 12; ++still) {
    s.request.still = still;
    last = s.draw(view);
  }
  s.request.still = 0;
  CHECK(last.width == first.width);
  CHECK(testing::difference(first, last) < 3);
  CHECK(testing::difference(first, last) > 0);
  // How much colours jump twice in a row, as they do at stairs and in noise.
  const auto roughness = [](const Picture& p) {
    double sum = 0;
    for (int y = 0; y < p.height; ++y)
      for (int x = 1; x + 1 < p.width; ++x)
        sum += std::abs(p.at(x - 1, y)[0] + p.at(x + 1, y)[0] - 2 * p.at(x, y)[0]);
    return sum;
  };
  CHECK(roughness(last) < 0.95 * roughness(first));
  CHECK(testing::difference(s.draw(view), first) < 0.01); // and it begins anew
}

TEST_CASE("a frame that is made strip by strip is the one that is made at once") {
  Studio& s = studio();
  ViewSettings view = nothing();
  view.zero_set.visible = view.outer.visible = view.inner.visible = true;
  const auto second = [&](int strips) {
    s.draw(view);
    s.request.still = 1;
    s.request.strips = strips;
    Picture last;
    for (s.request.strip = 0; s.request.strip < strips; ++s.request.strip) last = s.draw(view);
    s.request.still = s.request.strip = 0;
    s.request.strips = 1;
    return last;
  };
  const Picture whole = second(1);
  CHECK(testing::difference(second(4), whole) < 0.01);
  CHECK(testing::difference(s.draw(view), whole) > 0);
}

TEST_CASE(
    "haze tells how much of Ω a ray goes through, and the order of both boundaries holds from all sides") {
  Studio& s = studio();
  ViewSettings view = nothing();
  apply(volume_looks[3], view); // thickness
  const Picture thin = s.draw(view);
  const auto at_middle = thin.at(80, 70);
  int strongest = 0;
  for (int x = 0; x < 80; ++x)
    strongest = std::max(strongest, std::abs(thin.at(x, 70)[2] - s.draw(nothing()).at(x, 70)[2]));
  // A ray that grazes the ball stays in Ω for longer than one through its middle.
  CHECK(strongest > std::abs(at_middle[2] - s.draw(nothing()).at(80, 70)[2]) + 15);
  // Solid boundaries: from outside the cool one hides the warm one, cut open the warm one is before it.
  view = nothing();
  view.outer = view.inner = {true, 1.0f};
  const CameraPose pose = s.camera.pose();
  for (const int axis : {0, 1, 2})
    for (const int sign : {-1, 1}) {
      CAPTURE(axis);
      CAPTURE(sign);
      s.camera.look_along(axis, sign, false);
      view.clip.shape = ClipSettings::Shape::none;
      CHECK(bluish(s.draw(view).at(80, 70)));
      view.clip.shape = ClipSettings::Shape::plane;
      view.clip.point = s.sphere.scene->input->bounds().center();
      view.clip.normal = normalized(s.camera.eye() - s.camera.pose().target);
      const auto inside = s.draw(view).at(80, 70);
      CHECK(inside[0] > inside[1] + 15);
    }
  s.camera.set(pose);
}

TEST_CASE("the face of a cut shows Ω's band with Z's line and the samples on it") {
  Studio& s = studio();
  ViewSettings view = nothing();
  view.outer.visible = view.inner.visible = true;
  view.clip.shape = ClipSettings::Shape::plane;
  view.clip.point = s.sphere.scene->input->bounds().center();
  view.clip.normal = normalized(s.camera.eye() - s.camera.pose().target);
  const Picture band = s.draw(view);
  CHECK(band.count(bluish) > 300);
  view.zero_set.visible = true;
  const Picture with_line = s.draw(view);
  const auto white = [](const Picture::Color& c) { return c[0] > 225 && c[1] > 225 && c[2] > 225; };
  CHECK(with_line.count(white) > band.count(white) + 100);
  view.zero_set.visible = false;
  view.samples.visible = true;
  view.sample_size = 8;
  CHECK(s.draw(view).count(green) > 60);
  // Seen from behind the face does not lie open.
  view.clip.flipped = true;
  view.clip.normal = -view.clip.normal;
  view.samples.visible = false;
  view.zero_set.visible = true;
  CHECK(testing::difference(s.draw(view), with_line) < 0.01);
  view.clip.flipped = false;
  CHECK(testing::difference(s.draw(view), with_line) > 3);
}
