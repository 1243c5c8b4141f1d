// The certificate against defects planted so finely that only exact and proven tests can see them.
#include "run/certificate.h"

#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

constexpr double delta = 0.04;

/// An input with its volume, and meshes judged against it.
struct Judge {
  ToleranceVolume volume;
  ExpectedTopology expected;

  static ToleranceVolume build(const TriangleSoup& soup) {
    auto volume = ToleranceVolume::build(std::make_shared<const ClosestPointIndex>(soup), analyse_input(soup),
                                         {delta, 0.95}, RunControl());
    REQUIRE(volume.ok());
    return std::move(*volume);
  }
  explicit Judge(const TriangleSoup& soup)
      : volume(build(soup)), expected(expected_topology(volume, TopologyMode::keep)) {}
  Certificate operator()(const TriangleSoup& m) const {
    return certify({m.points, m.triangles}, volume, expected, RunControl());
  }
};

TriangleSoup cube() {
  TriangleSoup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  return soup;
}

void append(TriangleSoup& soup, const TriangleSoup& more) {
  const auto base = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), more.points.begin(), more.points.end());
  for (const auto& t : more.triangles) soup.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
}

TriangleSoup turned(TriangleSoup soup) {
  for (auto& t : soup.triangles) std::swap(t[1], t[2]);
  return soup;
}

TriangleSoup tetrahedron(const std::array<Vec3, 4>& p) {
  TriangleSoup soup;
  soup.points.assign(p.begin(), p.end());
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return soup;
}

/// Two boxes side by side, or twice the same.
TriangleSoup boxes(Vec3 first, Vec3 second) {
  TriangleSoup soup;
  for (const Vec3 at : {first, second}) add_box(soup, at, at + Vec3{1, 1, 1});
  return soup;
}

TriangleSoup shell(bool exchanged) {
  TriangleSoup outer, cavity;
  add_sphere(outer, {}, 1, 12);
  add_sphere(cavity, {}, 0.6, 12);
  if (exchanged) {
    outer = turned(outer);
  } else {
    cavity = turned(cavity);
  }
  append(outer, cavity);
  return outer;
}

} // namespace

TEST_CASE("A vertex a billionth of δ outside of Ω is outside, a billionth inside is inside") {
  const Judge judge(cube());
  for (const double excess : {1e-9, -1e-9}) {
    CAPTURE(excess);
    TriangleSoup mesh = cube();
    const double along = delta * (1 + excess) / std::sqrt(3.0);
    mesh.points[7] += Vec3{along, along, along};
    const Certificate c = judge(mesh);
    CHECK(c.closed_manifold);
    CHECK(c.intersection_free);
    CHECK(c.within_tolerance == (excess < 0));
    CHECK(c.holds() == (excess < 0));
    CHECK(c.failures.size() == (excess < 0 ? 0 : 1));
  }
}

TEST_CASE("Facets that touch are an intersection, facets a hair apart are none") {
  const Judge judge(cube());
  const auto with = [](const std::function<TriangleSoup(double gap)>& part, double gap) {
    TriangleSoup mesh = cube();
    append(mesh, part(gap));
    return mesh;
  };
  // Each part stands on the cube's face z = 1 or at its edge y = 0, z = 1, in coordinates that doubles hold.
  const auto vertex_on_facet = [](double gap) {
    const double z = 1 + gap;
    return tetrahedron({{{0.25, 0.5, z}, {0, 0, z + 1}, {1, 0, z + 1}, {0, 1, z + 1}}});
  };
  const auto edge_on_edge = [](double gap) {
    return tetrahedron({{{0.5, -1, gap}, {0.5, 1, 2 + gap}, {1, -2, 2 + gap}, {0, -2, 2 + gap}}});
  };
  const auto facet_on_facet = [](double gap) {
    TriangleSoup soup;
    add_box(soup, {0.25, 0.25, 1 + gap}, {0.75, 0.75, 2});
    return soup;
  };
  const auto vertex_on_vertex = [](double gap) {
    TriangleSoup soup;
    add_box(soup, {1 + gap, 1 + gap, 1 + gap}, {2, 2, 2});
    return soup;
  };
  for (const std::function<TriangleSoup(double)>& part :
       {std::function<TriangleSoup(double)>(vertex_on_facet),
        {edge_on_edge},
        {facet_on_facet},
        {vertex_on_vertex}}) {
    const Certificate touching = judge(with(part, 0));
    CHECK(touching.closed_manifold);
    CHECK(touching.oriented);
    CHECK(!touching.intersection_free);
    CHECK(!touching.holds());
    CHECK(judge(with(part, 0x1p-50)).intersection_free);
  }
}

TEST_CASE("Facets folded over each other in one plane are an intersection") {
  const Judge judge(cube());
  // The face z = 1, corners 4, 5, 7 and 6, as a fan about a vertex of its own.
  const auto fan_about = [](Vec3 center) {
    TriangleSoup mesh = cube();
    mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
    mesh.points.push_back(center);
    for (const auto& [a, b] : {std::pair{4u, 5u}, {5u, 7u}, {7u, 6u}, {6u, 4u}})
      mesh.triangles.push_back({a, b, 8});
    return mesh;
  };
  CHECK(judge(fan_about({0.9, 0.5, 1})).holds());
  const Certificate c = judge(fan_about({1.02, 0.5, 1}));
  CHECK(c.closed_manifold);
  CHECK(c.oriented);
  CHECK(c.within_tolerance);
  CHECK(!c.intersection_free);
}

TEST_CASE("A swallowed component is missed, by its number and by its side") {
  const TriangleSoup both = boxes({0, 0, 0}, {3, 0, 0});
  const Judge judge(both);
  CHECK(judge(both).holds());
  const Certificate swallowed = judge(cube());
  CHECK(swallowed.within_tolerance);
  CHECK(!swallowed.topology_as_expected());
  CHECK(!swallowed.separates);
  // How far the mesh leaves the input behind is told too: the lost box ends at x = 4.
  CHECK(swallowed.input_distance.lower > 2.9);
  CHECK(swallowed.input_distance.upper < 3 + 0.02 * delta);
}

TEST_CASE("A component taken twice in place of another has the right numbers and the wrong sides") {
  const Judge judge(boxes({0, 0, 0}, {3, 0, 0}));
  TriangleSoup mesh = cube();
  add_box(mesh, {-0.01, -0.01, -0.01}, {1.01, 1.01, 1.01});
  const Certificate c = judge(mesh);
  CHECK(c.closed_manifold);
  CHECK(c.intersection_free);
  CHECK(c.within_tolerance);
  CHECK(c.topology_as_expected());
  CHECK(!c.separates);
  CHECK(!c.holds());
}

TEST_CASE("Two components with exchanged sides do not separate what they should") {
  const Judge judge(shell(false));
  CHECK(judge(shell(false)).holds());
  const Certificate c = judge(shell(true));
  CHECK(c.closed_manifold);
  CHECK(c.oriented);
  CHECK(c.intersection_free);
  CHECK(c.within_tolerance);
  CHECK(c.topology_as_expected());
  CHECK(!c.separates);
  CHECK(!c.holds());
}

TEST_CASE("A flipped facet is found among many, wherever it is") {
  TriangleSoup sphere;
  add_sphere(sphere, {}, 1, 8);
  const Judge judge(sphere);
  for (std::size_t f = 0; f < sphere.triangles.size(); f += 17) {
    TriangleSoup mesh = sphere;
    std::swap(mesh.triangles[f][0], mesh.triangles[f][2]);
    const Certificate c = judge(mesh);
    CHECK(c.closed_manifold);
    CHECK(!c.oriented);
    CHECK(!c.holds());
  }
}
