// Minimax placement against brute force, and the folding rule in every orientation of the input.
#include "improve/placement.h"
#include "improve/support.h"
#include "tolerance/closest_point.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

using namespace isoscope;
using isoscope::testing::Random;

namespace {

/// A closed fan around `apex` with n rim vertices on a circle of radius r at height z of the unit sphere's
/// pole.
Star cap(unsigned n, double r, double z) {
  Star star;
  for (unsigned i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    star.wedges.push_back({{r * std::cos(angle), r * std::sin(angle), z}, {}, {}, 0, {}});
  }
  star.fans.push_back({0, n, {}});
  return star;
}

TriangleMesh mesh_of(const TriangleSoup& soup) {
  return {soup.points, soup.triangles};
}

} // namespace

TEST_CASE("the placed apex of a cap over a sphere is as good as the best of a dense search") {
  TriangleSoup sphere;
  testing::add_sphere(sphere, {0, 0, 0}, 1, 40);
  const ClosestPointIndex index(sphere);
  const double delta = 0.05;
  const InputSurface input(index, delta, mesh_of(sphere));
  for (const unsigned n : {4u, 5u, 6u, 8u}) {
    const double r = 0.45;
    const Star star = cap(n, r, std::sqrt(1 - r * r));
    StarEvaluator evaluator(input, star);
    Placement placed = evaluator.evaluate({0.05, -0.03, 0.97});
    evaluator.improve(placed, 8);
    double best = Box3::inf;
    for (int i = 0; i <= 400; ++i) best = std::min(best, evaluator.evaluate({0, 0, 0.9 + 0.0005 * i}).energy);
    CHECK(std::pow(placed.energy, 1. / 12) <= 1.07 * std::pow(best, 1. / 12)); // in terms of distances
    CHECK(placed.point.z > 1); // the far side of the surface: the facets sink below it
  }
}

TEST_CASE("improving never makes a star worse, from any start") {
  TriangleSoup torus;
  testing::add_torus(torus, {0, 0, 0}, 1, 0.4, 30);
  const ClosestPointIndex index(torus);
  const InputSurface input(index, 0.04, mesh_of(torus));
  Random random(11);
  for (int i = 0; i < 50; ++i) {
    Star star = cap(6, random.between(0.1, 0.3), 0.4);
    for (auto& wedge : star.wedges) wedge.rim = wedge.rim + Vec3{1, 0, 0} + 0.02 * random.direction();
    StarEvaluator evaluator(input, star);
    const Vec3 start = Vec3{1, 0, 0.4} + 0.1 * random.direction();
    Placement placed = evaluator.evaluate(start);
    const double before = placed.energy;
    evaluator.improve(placed, 4);
    CHECK(placed.energy <= before);
    CHECK(StarEvaluator(input, star).evaluate(placed.point).energy ==
          doctest::Approx(placed.energy).epsilon(0.02));
  }
}

TEST_CASE("an evaluation stops early past its limits alone") {
  TriangleSoup sphere;
  testing::add_sphere(sphere, {0, 0, 0}, 1, 24);
  const ClosestPointIndex index(sphere);
  const InputSurface input(index, 0.02, mesh_of(sphere));
  const Star star = cap(6, 0.5, std::sqrt(0.75));
  StarEvaluator evaluator(input, star);
  constexpr double never = std::numeric_limits<double>::infinity();
  const Placement whole = evaluator.evaluate({0, 0, 1});
  const double full = whole.energy;
  CHECK(full < never);
  CHECK(evaluator.evaluate({0, 0, 1}, 0.1 * full).energy == never);
  CHECK(evaluator.evaluate({0, 0, 1}, 2 * full).energy == full);
  CHECK(evaluator.evaluate({0, 0, 1}, never, 0.5 * whole.largest).energy == never);
  CHECK(evaluator.evaluate({0, 0, 1}, never, whole.largest).energy == full);
}

TEST_CASE("a facet that is turned around is folded, whichever way the input's triangles run") {
  TriangleSoup sphere;
  testing::add_sphere(sphere, {0, 0, 0}, 1, 24);
  const TriangleMesh mesh = mesh_of(sphere);
  TriangleSoup turned = sphere, mixed = testing::exploded(sphere, 1);
  for (auto& t : turned.triangles) std::swap(t[0], t[1]);
  for (std::size_t i = 0; i < mixed.triangles.size(); i += 3)
    std::swap(mixed.triangles[i][1], mixed.triangles[i][2]);
  for (const TriangleSoup& soup : {sphere, turned, mixed}) {
    const ClosestPointIndex index(soup);
    const InputSurface input(index, 0.1, mesh);
    Random random(2);
    for (int i = 0; i < 100; ++i) {
      const Vec3 n = random.direction();
      const Vec3 u = normalized(cross(n, std::abs(n.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0})),
                 v = cross(n, u);
      const Triangle3 outward{n + 0.1 * u, n + 0.1 * v, n - 0.1 * u - 0.1 * v};
      const Triangle3 inward{outward[0], outward[2], outward[1]};
      TriangleId seed;
      CHECK_FALSE(measure_facet(input, outward, {}, {}, seed).folded);
      CHECK(measure_facet(input, inward, {}, {}, seed).folded);
    }
  }
}

TEST_CASE("a needle without area is folded") {
  TriangleSoup sphere;
  testing::add_sphere(sphere, {0, 0, 0}, 1, 24);
  const ClosestPointIndex index(sphere);
  const InputSurface input(index, 0.1, mesh_of(sphere));
  TriangleId seed;
  CHECK(measure_facet(input, {Vec3{1, 0, 0}, Vec3{1, 0.1, 0}, Vec3{1, 0.05, 0}}, {}, {}, seed).folded);
}

TEST_CASE("a side sample pulls the facet's plane back over it") {
  // A flat input; the sample of the positive side lies just below a tilted facet's plane.
  TriangleSoup square;
  square.points = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const double delta = 1;
  const SideSample side{{0, 0, 0.5}, +1};
  const Triangle3 above{Vec3{-1, -1, 0.7}, Vec3{1, -1, 0.7}, Vec3{0, 1, 0.7}};
  const Triangle3 below{Vec3{-1, -1, 0.1}, Vec3{1, -1, 0.1}, Vec3{0, 1, 0.1}};
  CHECK(side_distance(side, above, delta).distance == doctest::Approx(1.2));
  CHECK(side_distance(side, below, delta).distance == doctest::Approx(0.6));
  CHECK(side_distance(side, above, delta).direction.z == doctest::Approx(1));
  const Barycentric foot = side_distance(side, above, delta).foot;
  CHECK(distance(at(foot, above), Vec3{0, 0, 0.7}) < 1e-12);
}
