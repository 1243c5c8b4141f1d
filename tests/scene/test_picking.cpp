// Picking: the nearest visible thing, deeper on demand, never behind the clip.
#include "scene/picking.h"

#include "scene/fabricate.h"
#include "scene/overlay.h"
#include "scene/pick_geometry.h"
#include "scene/section_view.h"

#include <doctest/doctest.h>

using namespace isoscope;
using Kind = Pick::Kind;

namespace {

constexpr int width = 400, height = 300;

/// Two tetrahedra along the z axis, the first nearer to the viewer; both carry Z.
StateSnapshot two_tetrahedra() {
  StateSnapshot state;
  const auto add = [&](double z) {
    const std::array<Vec3, 4> p{Vec3{-1, -1, z}, Vec3{1, -1, z}, Vec3{0, 1, z}, Vec3{0, 0, z + 0.8}};
    Tet tet;
    for (std::size_t i = 0; i < 4; ++i) {
      tet.v[i] = VertexId(state.complex.vertices.size());
      Vertex v;
      v.position = p[i];
      v.value = i == 3 ? 1 : -1;
      state.complex.vertices.push_back(v);
    }
    state.complex.tets.push_back(tet);
    state.tet_flags.push_back(tet_alive | tet_heterogeneous);
  };
  add(0);
  add(-3);
  return state;
}

Camera front() {
  Camera camera;
  CameraPose pose;
  pose.distance = 10;
  camera.set(pose);
  return camera;
}

ViewSettings only_tetrahedra() {
  ViewSettings view;
  view.tets.all = true;
  view.zero_set.visible = view.samples.visible = view.outer.visible = view.inner.visible = false;
  return view;
}

PickAt at(const Camera& camera, Vec3 p) {
  const ScreenPoint s = project(camera, p, width, height);
  return {s.x, s.y, width, height};
}

} // namespace

TEST_CASE("tetrahedra: nearest first, deeper by index, nothing beside them") {
  const StateSnapshot state = two_tetrahedra();
  const PickScene scene{&state, nullptr, nullptr};
  const Camera camera = front();
  const ViewSettings view = only_tetrahedra();
  const PickAt middle = at(camera, {0, -0.2, 0});
  CHECK(pick_scene(scene, camera, view, middle, PickKinds::tetrahedra, 0).id == 0);
  CHECK(pick_scene(scene, camera, view, middle, PickKinds::tetrahedra, 1).id == 1);
  CHECK(pick_scene(scene, camera, view, middle, PickKinds::tetrahedra, 2).kind == Kind::none);
  CHECK(pick_scene(scene, camera, view, middle, PickKinds::samples, 0).kind == Kind::none);
  CHECK(pick_scene(scene, camera, view, at(camera, {3, 2, 0}), PickKinds::tetrahedra, 0).kind == Kind::none);
}

TEST_CASE("a boundary sample is told from a sample, in space and in the section") {
  StateSnapshot state = two_tetrahedra();
  auto samples = std::make_shared<BoundarySamples>();
  samples->positions = {{2, 0, 0}};
  samples->labels = {1};
  samples->over_rim = {{-2, 0, 0}, {-2, 1, 0}};
  samples->sigma = 0.2;
  state.samples = samples;
  const PickScene scene{&state, nullptr, nullptr};
  const Camera camera = front();
  ViewSettings view = only_tetrahedra();
  view.samples.visible = true;
  const Pick found = pick_scene(scene, camera, view, at(camera, {-2, 1, 0}), PickKinds::samples, 0);
  CHECK(found.kind == Kind::over_rim);
  CHECK(found.id == 1);
  CHECK(found.point == Vec3{-2, 1, 0});
  CHECK(pick_scene(scene, camera, view, at(camera, {2, 0, 0}), PickKinds::samples, 0).kind == Kind::sample);
  CHECK(pick_bounds(state, found).center() == Vec3{-2, 1, 0});

  view.clip.normal = {0, 0, 1};
  const Renderer::SectionView section{0, 0, 6};
  const Camera flat = section_camera(section, view.clip);
  const Pick cut =
      pick_section_scene(state, nullptr, section, view, at(flat, {-2, 1, 0}), PickKinds::samples);
  CHECK(cut.kind == Kind::over_rim);
  CHECK(cut.id == 1);

  view.over_rim.visible = false;
  CHECK(pick_scene(scene, camera, view, at(camera, {-2, 1, 0}), PickKinds::samples, 0).kind == Kind::none);
}

TEST_CASE("the display shrink is respected") {
  const StateSnapshot state = two_tetrahedra();
  const PickScene scene{&state, nullptr, nullptr};
  const Camera camera = front();
  ViewSettings view = only_tetrahedra();
  const PickAt corner = at(camera, {-0.85, -0.95, 0});
  view.tets.shrink = 1;
  CHECK(pick_scene(scene, camera, view, corner, PickKinds::tetrahedra, 0).kind == Kind::tet);
  view.tets.shrink = 0.5;
  CHECK(pick_scene(scene, camera, view, corner, PickKinds::tetrahedra, 0).kind == Kind::none);
}

TEST_CASE("filters and layers hide from picking") {
  const StateSnapshot state = two_tetrahedra();
  const PickScene scene{&state, nullptr, nullptr};
  const Camera camera = front();
  ViewSettings view = only_tetrahedra();
  const PickAt middle = at(camera, {0, -0.2, 0});
  view.tets.all = false;
  CHECK(pick_scene(scene, camera, view, middle, PickKinds::tetrahedra, 0).kind == Kind::none);
  view.tets.carry_zero_set = true;
  CHECK(pick_scene(scene, camera, view, middle, PickKinds::tetrahedra, 0).kind == Kind::tet);
  view.tetrahedra.visible = false;
  CHECK(pick_scene(scene, camera, view, middle, PickKinds::tetrahedra, 0).kind == Kind::none);
}

TEST_CASE("nothing behind the clip can be picked") {
  const StateSnapshot state = two_tetrahedra();
  const PickScene scene{&state, nullptr, nullptr};
  const Camera camera = front();
  ViewSettings view = only_tetrahedra();
  const PickAt middle = at(camera, {0, -0.2, 0});
  view.clip.shape = ClipSettings::Shape::plane;
  view.clip.normal = {0, 0, 1};
  view.clip.point = {0, 0, -0.5};
  for (const auto mode : {ClipSettings::Mode::cut, ClipSettings::Mode::whole_cells}) {
    view.clip.mode = mode;
    CHECK(pick_scene(scene, camera, view, middle, PickKinds::tetrahedra, 0).id == 1);
    CHECK(pick_scene(scene, camera, view, middle, PickKinds::tetrahedra, 1).kind == Kind::none);
  }
  // Cut through the near one: the hit lies on the cut.
  view.clip.point = {0, 0, 0.3};
  view.clip.mode = ClipSettings::Mode::cut;
  view.tets.shrink = 1;
  const Pick cut = pick_scene(scene, camera, view, at(camera, {0, -0.05, 0.3}), PickKinds::tetrahedra, 0);
  CHECK(cut.id == 0);
  CHECK(cut.point.z == doctest::Approx(0.3));
  view.clip.mode = ClipSettings::Mode::straddle;
  CHECK(pick_scene(scene, camera, view, middle, PickKinds::tetrahedra, 0).id == 0);
  CHECK(pick_scene(scene, camera, view, middle, PickKinds::tetrahedra, 1).kind == Kind::none);
}

TEST_CASE("the zero set picks the tetrahedron that carries it and hides what is behind") {
  StateSnapshot state = two_tetrahedra();
  state.zero_set = extract_zero_set(state.complex);
  auto samples = std::make_shared<BoundarySamples>();
  samples->positions = {{-0.5, -0.5, 1.5}, {0, -0.1, -2}};
  samples->labels = {1, -1};
  samples->sigma = 0.1;
  state.samples = samples;
  state.errors = {0.0f, 2.0f};
  state.sample_tets = {TetId(), TetId()};
  const PickScene scene{&state, nullptr, nullptr};
  const Camera camera = front();
  ViewSettings view;
  view.tetrahedra.visible = false;
  const PickAt middle = at(camera, {0, -0.1, 0});
  CHECK(pick_scene(scene, camera, view, middle, PickKinds::tetrahedra, 0).id == 0);
  CHECK(pick_scene(scene, camera, view, at(camera, samples->positions[0]), PickKinds::samples, 0).id == 0);
  const PickAt behind = at(camera, samples->positions[1]);
  CHECK(pick_scene(scene, camera, view, behind, PickKinds::samples, 0).kind == Kind::none);
  view.zero_set.opacity = 0.5f;
  CHECK(pick_scene(scene, camera, view, behind, PickKinds::samples, 0).id == 1);
  view.bad_samples.visible = false;
  CHECK(pick_scene(scene, camera, view, behind, PickKinds::samples, 0).kind == Kind::none);
}

TEST_CASE("a vertex under the cursor wins over the cell around it") {
  const StateSnapshot state = two_tetrahedra();
  const PickScene scene{&state, nullptr, nullptr};
  const Camera camera = front();
  ViewSettings view = only_tetrahedra();
  view.tets.shrink = 1;
  const Vec3 apex = state.complex.vertices[3].position;
  const Pick pick =
      pick_scene(scene, camera, view, at(camera, apex), PickKinds::vertices | PickKinds::tetrahedra, 0);
  CHECK(pick.kind == Kind::vertex);
  CHECK(pick.id == 3);
}

TEST_CASE("the point under the cursor: on a surface, else at the target's depth") {
  const StateSnapshot state = two_tetrahedra();
  const PickScene scene{&state, nullptr, nullptr};
  const Camera camera = front();
  ViewSettings view = only_tetrahedra();
  view.tets.shrink = 1;
  const Vec3 hit = surface_point(scene, camera, view, at(camera, {0, 0, 0.8}));
  CHECK(distance(hit, {0, 0, 0.8}) < 1e-6);
  const Vec3 free = surface_point(scene, camera, view, {10, 10, width, height});
  CHECK(free.z == doctest::Approx(0));
}

TEST_CASE("picking in the section finds the tetrahedron around the position") {
  const StateSnapshot state = two_tetrahedra();
  ViewSettings view;
  view.clip.point = {0, 0, 0.1};
  view.clip.normal = {0, 0, 1};
  const Renderer::SectionView section{0, 0, 4};
  CHECK(pick_section_scene(state, nullptr, section, view, {200, 155, 400, 300}, PickKinds::tetrahedra).id ==
        0);
  CHECK(pick_section_scene(state, nullptr, section, view, {20, 20, 400, 300}, PickKinds::tetrahedra).kind ==
        Kind::none);
}

TEST_CASE("what is framed is seen from where nothing of Z hides it") {
  // A floor that faces up, with a roof over its left half.
  ZeroSet zero;
  const auto triangle = [&](Vec3 a, Vec3 b, Vec3 c) {
    ZeroSet::Polygon polygon;
    polygon.count = 3;
    const auto first = static_cast<std::uint32_t>(zero.vertices.size());
    for (const Vec3& p : {a, b, c}) {
      ZeroSet::ZeroVertex v;
      v.position = p;
      zero.vertices.push_back(v);
    }
    polygon.v = {first, first + 1, first + 2, 0};
    zero.polygons.push_back(polygon);
  };
  triangle({-10, -10, 0}, {10, -10, 0}, {0, 15, 0});
  const Vec3 up{0, 0, 1}, place{0, 0, 0};
  CHECK(unhidden_direction(zero, place, up, up, 5) == up);
  CHECK(unhidden_direction(zero, place, -up, up, 5) == up);
  triangle({-4, -4, 2}, {1, -4, 2}, {-1, 6, 2});
  CHECK(unhidden_direction(zero, place, up, up, 1) == up); // the roof is farther than the eye
  const Vec3 side = unhidden_direction(zero, place, up, up, 5);
  CHECK(side != up);
  CHECK(side.z > 0.3);
  CHECK((side.x > 0 || side.y > 0)); // past the right edge of the roof or its tip
  // All around is a wall: the normal, for want of better.
  triangle({-40, -40, 1}, {40, -40, 1}, {0, 60, 1});
  CHECK(unhidden_direction(zero, place, -up, up, 5) == up);
}
