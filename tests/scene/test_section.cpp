// The 2D section against brute force.
#include "scene/sample_scope.h"
#include "scene/section_attempt.h"
#include "scene/section_geometry.h"
#include "scene/section_view.h"

#include "base/labels.h"
#include "input/gallery.h"
#include "scene/fabricate.h"
#include "scene/overlay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

using namespace isoscope;

namespace {

const testing::Fabricated& torus() {
  static const testing::Fabricated made = testing::fabricate(*make_gallery_model("torus"), 4, 1, 60, 32);
  return made;
}

SectionPlane slanted() {
  SectionPlane plane;
  plane.origin = torus().scene->input->bounds().center() + Vec3{0.013, 0.007, 0.005};
  plane.axes = plane_axes({0.4, 0.3, 0.8});
  return plane;
}

/// Of the convex hull of the segments' ends.
double hull_area(const std::vector<SectionGeometry::Segment>& segments) {
  std::vector<PlanePoint> points;
  for (const auto& s : segments) points.insert(points.end(), {s.a, s.b});
  std::sort(points.begin(), points.end(), [](const PlanePoint& p, const PlanePoint& q) {
    return std::pair(p.u, p.v) < std::pair(q.u, q.v);
  });
  const auto turn = [](const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
  };
  std::vector<PlanePoint> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t begin = hull.size();
    for (const PlanePoint& p : points) {
      while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  double sum = 0;
  for (std::size_t i = 1; i + 1 < hull.size(); ++i) sum += 0.5 * turn(hull[0], hull[i], hull[i + 1]);
  return sum;
}

double total(const std::vector<SectionGeometry::Segment>& segments) {
  double sum = 0;
  for (const auto& s : segments) sum += std::hypot(s.a.u - s.b.u, s.a.v - s.b.v);
  return sum;
}

} // namespace

TEST_CASE("coordinates of the plane go there and back") {
  const SectionPlane plane = slanted();
  const PlanePoint p{0.25, -0.75};
  const PlanePoint q = plane.project(plane.lift(p));
  CHECK(q.u == doctest::Approx(p.u));
  CHECK(q.v == doctest::Approx(p.v));
  CHECK(std::abs(plane.height(plane.lift(p))) < 1e-12);
}

TEST_CASE("every shared facet is drawn once") {
  const StateSnapshot& state = *torus().state;
  const SectionPlane plane = slanted();
  const SectionGeometry geometry = section_geometry(state, plane, {true, 0});
  // By brute force: each facet with corners on both sides, keyed by its sorted corners.
  std::map<std::array<VertexId, 3>, int> crossed;
  for (const Tet& tet : state.complex.tets) {
    if (!tet.alive()) continue;
    for (std::size_t skip = 0; skip < 4; ++skip) {
      std::array<VertexId, 3> facet;
      std::size_t n = 0;
      int above = 0;
      for (std::size_t i = 0; i < 4; ++i)
        if (i != skip) {
          facet[n++] = tet.v[i];
          above += plane.height(state.complex.position(tet.v[i])) >= 0 ? 1 : 0;
        }
      std::sort(facet.begin(), facet.end());
      if (above > 0 && above < 3) ++crossed[facet];
    }
  }
  CHECK(geometry.tetrahedra.size() == crossed.size());
}

TEST_CASE("the zero set's section is made of closed curves on which f vanishes") {
  const StateSnapshot& state = *torus().state;
  const SectionPlane plane = slanted();
  const SectionGeometry geometry = section_geometry(state, plane, {true, 0});
  REQUIRE(geometry.zero_set.size() > 4);
  std::map<std::pair<long, long>, int> ends;
  const auto key = [](PlanePoint p) { return std::pair{std::lround(p.u * 1e9), std::lround(p.v * 1e9)}; };
  for (const auto& s : geometry.zero_set) {
    ++ends[key(s.a)];
    ++ends[key(s.b)];
    const PlanePoint middle{0.5 * (s.a.u + s.b.u), 0.5 * (s.a.v + s.b.v)};
    const TetId tet = section_tet(state, plane, middle, true);
    REQUIRE(tet.valid());
    const AffineFunction f = interpolate(state.complex.positions(tet), state.complex.values(tet));
    CHECK(std::abs(f(plane.lift(middle))) < 1e-6);
  }
  std::size_t even = 0;
  for (const auto& [point, count] : ends) even += count % 2 == 0 ? 1u : 0u;
  CHECK(even == ends.size());
  CHECK(total(geometry.gamma) > total(geometry.zero_set)); // ∂Γ encloses Z on both sides
}

TEST_CASE("samples are those near the plane, with their classes") {
  const StateSnapshot& state = *torus().state;
  const SectionPlane plane = slanted();
  const double reach = section_sample_distance(state);
  CHECK(reach == doctest::Approx(0.5 * state.samples->sigma));
  const SectionGeometry geometry = section_geometry(state, plane, {true, reach});
  std::size_t expected = 0;
  for (const Vec3 p : state.samples->positions) expected += std::abs(plane.height(p)) <= reach ? 1u : 0u;
  CHECK(expected > 0);
  CHECK(geometry.samples.size() == expected);
  for (const auto& s : geometry.samples) {
    CHECK(s.bad == (state.errors[s.id.index()] >= 1.0f));
    CHECK(s.outer == (state.samples->labels[s.id.index()] > 0));
  }
}

TEST_CASE("rooms fill the section of T by label, and their parts meet along Z") {
  const testing::Fabricated made = testing::fabricate(*make_gallery_model("two-rooms"), 6, 1, 80, 16);
  const StateSnapshot& state = *made.state;
  REQUIRE(state.zero_set.has_rooms());
  SectionPlane plane;
  plane.origin = made.scene->input->bounds().center() + Vec3{0.013, 0.007, 0.005};
  plane.axes = plane_axes({0.2, 0.1, 0.9});
  const SectionGeometry geometry = section_geometry(state, plane, {true, 0});
  const auto area = [](const SectionGeometry::Cell& cell) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < cell.count; ++i) {
      const PlanePoint a = cell.corners[0], b = cell.corners[i], c = cell.corners[i + 1];
      sum += 0.5 * ((b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u));
    }
    return std::abs(sum);
  };
  std::map<int, double> by_label;
  double filled = 0;
  for (const SectionGeometry::Cell& cell : geometry.cells) {
    by_label[cell.label] += area(cell);
    filled += area(cell);
    PlanePoint middle;
    for (std::size_t i = 0; i < cell.count; ++i) {
      middle.u += cell.corners[i].u / static_cast<double>(cell.count);
      middle.v += cell.corners[i].v / static_cast<double>(cell.count);
    }
    const TetId tet = section_tet(state, plane, middle, true);
    if (!tet.valid() || label_count(state.complex.labels(tet)) > 2) continue;
    const auto f = seen_from(cell.label, state.complex.values(tet), state.complex.labels(tet));
    CHECK(interpolate(state.complex.positions(tet), f)(plane.lift(middle)) > -1e-6);
  }
  CHECK(by_label.size() == 3);
  // Nothing is filled twice and nothing left out: T is a convex polyhedron, whose section is the hull of its
  // outermost segments' ends.
  CHECK(filled == doctest::Approx(hull_area(geometry.tetrahedra)).epsilon(1e-6));
  for (const SectionGeometry::Crossing& x : geometry.crossings) CHECK_FALSE(x.border);
  CHECK(geometry.crossings.size() >= 2);
}

TEST_CASE("the section's camera shows the plane's coordinates upright") {
  ClipSettings clip;
  clip.point = {1, 2, 3};
  clip.normal = normalized(Vec3{0.2, -0.5, 0.7});
  const Renderer::SectionView view{0.5, -0.25, 2};
  const Camera camera = section_camera(view, clip);
  const SectionPlane plane = section_plane(clip);
  const ScreenPoint center = project(camera, plane.lift({0.5, -0.25}), 400, 200);
  CHECK(center.x == doctest::Approx(200));
  CHECK(center.y == doctest::Approx(100));
  const ScreenPoint up = project(camera, plane.lift({0.5, 0.75}), 400, 200);
  CHECK(up.x == doctest::Approx(200));
  CHECK(up.y == doctest::Approx(0).epsilon(1e-9));
}

TEST_CASE("a plane cuts a box in a convex polygon, and hatching stays within it") {
  SectionPlane plane;
  plane.origin = {0.5, 0.5, 0.5};
  plane.axes = plane_axes({0, 0, 1});
  const Box3 unit{{0, 0, 0}, {1, 1, 1}};
  CHECK(cut_box(unit, plane).size() == 4);
  plane.axes = plane_axes({1, 1, 1});
  const auto hexagon = cut_box(unit, plane);
  REQUIRE(hexagon.size() == 6);
  for (const PlanePoint& p : hexagon) CHECK(std::hypot(p.u, p.v) == doctest::Approx(std::sqrt(0.5)));
  plane.origin = {5, 5, 5};
  CHECK(cut_box(unit, plane).empty());
  const auto lines = hatch_lines(hexagon, 0.1);
  CHECK(lines.size() >= 12);
  for (const auto& line : lines)
    for (const PlanePoint& p : line) CHECK(std::hypot(p.u, p.v) <= std::sqrt(0.5) + 1e-12);
  CHECK(hatch_lines(hexagon, 0).empty());
  CHECK(hatch_lines(hexagon, 1e-9).empty());
}

TEST_CASE("good samples are shown around the point that went in, or all of them") {
  const StateSnapshot& state = *torus().state;
  ViewSettings view;
  StateSnapshot after = state;
  after.event = Event{};
  REQUIRE(!after.complex.vertices.empty());
  after.inserted = VertexId(after.complex.vertices.size() - 1);
  const Vec3 place = after.complex.position(after.inserted);
  const SampleScope near(after, view);
  std::size_t shown = 0;
  for (const Vec3& p : state.samples->positions) shown += near.shows_good(p) ? 1u : 0u;
  CHECK(near.shows_good(place));
  CHECK(shown > 0);
  CHECK(shown < state.samples->size() / 4);
  view.near_samples = false;
  for (const Vec3& p : state.samples->positions) CHECK(SampleScope(after, view).shows_good(p));
  view.near_samples = true;
  StateSnapshot before = state;
  before.event.reset();
  CHECK(SampleScope(before, view).shows_good({1e6, 0, 0}));
}
