// Embedded and free Z: picked, cut and told apart before and after an operation.
#include "scene/zero_forms.h"

#include "journal/vocabulary.h"
#include "scene/overlay.h"
#include "scene/pick_geometry.h"
#include "scene/picking.h"
#include "scene/section_geometry.h"
#include "scene/tet_visibility.h"
#include "scene/zero_facets.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace isoscope;
using testing::embedded_facet;
using testing::free_tetrahedron;
using Kind = Pick::Kind;

namespace {

constexpr int width = 400, height = 300;

Camera front() {
  Camera camera;
  CameraPose pose;
  pose.distance = 5;
  camera.set(pose);
  return camera;
}

PickAt at(const Camera& camera, Vec3 p) {
  const ScreenPoint s = project(camera, p, width, height);
  return {s.x, s.y, width, height};
}

ViewSettings only_zero_set() {
  ViewSettings view;
  view.tetrahedra.visible = view.samples.visible = view.outer.visible = view.inner.visible = false;
  return view;
}

} // namespace

TEST_CASE("a free Z: its facets, edges and vertices are picked") {
  const StateSnapshot state = free_tetrahedron();
  REQUIRE(state.zero_set.polygons.size() == 4);
  const PickScene scene{&state, nullptr, nullptr};
  const Camera camera = front();
  const ViewSettings view = only_zero_set();
  const PickAt face = at(camera, {-0.25, -0.1, 0.2}), edge = at(camera, {-0.5, -0.5, 0}),
               apex = at(camera, {0, 0, 1});
  CHECK(pick_scene(scene, camera, view, face, PickKinds::all, 0).kind == Kind::facet);
  const Pick found = pick_scene(scene, camera, view, edge, PickKinds::all, 0);
  CHECK(found.kind == Kind::edge);
  CHECK(std::set{found.id, found.other} == std::set<std::uint32_t>{0, 3});
  const Pick vertex = pick_scene(scene, camera, view, apex, PickKinds::all, 0);
  CHECK(vertex.kind == Kind::vertex);
  CHECK(vertex.id == 3);
  // The edges of the facet behind are hidden, but deeper picks reach them.
  const PickAt behind = at(camera, {0, -1, -1});
  CHECK(pick_scene(scene, camera, view, behind, PickKinds::edges, 0).kind == Kind::edge);
  ViewSettings hidden = view;
  hidden.zero_set.visible = false;
  CHECK(pick_scene(scene, camera, hidden, face, PickKinds::all, 0).kind == Kind::none);
  // A clip takes away what it cuts, and whole cells by the facet itself.
  ViewSettings clipped = view;
  clipped.clip.shape = ClipSettings::Shape::plane;
  clipped.clip.normal = {0, 0, 1};
  clipped.clip.point = {0, 0, -0.5};
  const Pick cut = pick_scene(scene, camera, clipped, face, PickKinds::tetrahedra, 0);
  CHECK(cut.kind == Kind::facet);
  CHECK(state.complex.facets[cut.id].v[0].value != 3);
  clipped.clip.mode = ClipSettings::Mode::whole_cells;
  CHECK(shows_polygon(state, state.zero_set.polygons[3], Clip(clipped.clip)));
}

TEST_CASE("an embedded Z: edges of Z are pairs of vertices, cells have sides") {
  const StateSnapshot state = embedded_facet();
  REQUIRE(state.zero_set.polygons.size() == 1);
  const PickScene scene{&state, nullptr, nullptr};
  const Camera camera = front();
  const ViewSettings view = only_zero_set();
  const Pick found = pick_scene(scene, camera, view, at(camera, {0, -1, 0}), PickKinds::all, 0);
  CHECK(found.kind == Kind::edge);
  CHECK(std::set{found.id, found.other} == std::set<std::uint32_t>{0, 1});
  const auto ends = edge_positions(state, found);
  REQUIRE(ends.has_value());
  CHECK(pick_bounds(state, found).extent().x == 2);
  CHECK(pick_scene(scene, camera, view, at(camera, {0.1, -0.5, 0}), PickKinds::all, 0).kind == Kind::tet);

  TetFilter filter;
  filter.all = true;
  const auto count = [&](TetFilter::Sides sides) {
    filter.sides = sides;
    int n = 0;
    for_each_visible_tet(state, filter, Clip({}), [&](TetId, TetRole) { ++n; });
    return n;
  };
  CHECK(count(TetFilter::Sides::both) == 2);
  CHECK(count(TetFilter::Sides::outer) == 1);
  CHECK(count(TetFilter::Sides::inner) == 1);
  filter.sides = TetFilter::Sides::inner;
  CHECK(tet_role(state.tet_flags[0], filter, true) == TetRole::hidden);
  CHECK(tet_role(state.tet_flags[0], filter, false) == TetRole::plain);
}

TEST_CASE("a section cuts Z and the cells of both sides") {
  const StateSnapshot state = embedded_facet();
  SectionPlane plane;
  plane.origin = {0.1, 0, 0};
  plane.axes = plane_axes({1, 0, 0});
  const SectionGeometry cut = section_geometry(state, plane, {});
  CHECK(cut.zero_set.size() == 1);
  REQUIRE(cut.cells.size() == 2);
  CHECK(cut.cells[0].label != cut.cells[1].label);
  const auto area = [](const SectionGeometry::Cell& cell) {
    double twice = 0;
    for (std::size_t i = 0; i < cell.count; ++i) {
      const PlanePoint a = cell.corners[i], b = cell.corners[(i + 1) % cell.count];
      twice += a.u * b.v - a.v * b.u;
    }
    return std::abs(twice) / 2;
  };
  // The two are mirror images; each is the triangle over the cut of Z.
  CHECK(area(cut.cells[0]) == doctest::Approx(area(cut.cells[1])));
  CHECK(area(cut.cells[0]) > 0.5);
  const StateSnapshot free = free_tetrahedron();
  const SectionGeometry loop = section_geometry(free, plane, {});
  CHECK(loop.cells.empty());
  CHECK(loop.zero_set.size() == 3);
}

TEST_CASE("what the operation added is known among the polygons") {
  StateSnapshot state = free_tetrahedron();
  CHECK(new_polygons(state) == std::vector<std::uint8_t>(4, 0));
  const auto& v = state.complex.facets[2].v;
  // Any rotation of the corners will do.
  state.added_facets.push_back(
      {state.complex.position(v[1]), state.complex.position(v[2]), state.complex.position(v[0])});
  CHECK(new_polygons(state) == std::vector<std::uint8_t>{0, 0, 1, 0});
}

TEST_CASE("an edge that was collapsed lies where it was") {
  StateSnapshot state = free_tetrahedron();
  state.complex.vertices[1].alive = false;
  state.moves.push_back({VertexId(1), {5, 0, 0}, {1, -1, -1}});
  Pick edge;
  edge.kind = Kind::edge;
  edge.id = 0;
  edge.other = 1;
  const auto ends = edge_positions(state, edge);
  REQUIRE(ends.has_value());
  CHECK((*ends)[1] == Vec3{5, 0, 0});
  edge.other = 99;
  CHECK(!edge_positions(state, edge).has_value());
  CHECK(pick_bounds(state, edge).empty());
}

TEST_CASE("every reason for a rejection has a look of its own") {
  std::set<std::string> looks, titles;
  for (const Reason reason : rejecting_reasons) {
    const ReasonWords& style = words(reason);
    CHECK(!style.help.empty());
    CHECK(titles.insert(std::string(style.title)).second);
    CHECK(looks.insert(std::to_string(style.color) + "/" + std::to_string(static_cast<int>(style.shape)))
              .second);
  }
  CHECK(words(Reason::none).title == "taken");
  CHECK(words(Reason::kernel_sampling).title == "sampled kernel");
}
