// Bounds of the one-sided Hausdorff distance: known answers, brute force, the same bits on any number of
// threads.
#include "run/reverse_distance.h"

#include "base/parallel.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

ClosestPointIndex index_of(const std::vector<Triangle3>& triangles) {
  TriangleSoup soup;
  for (const Triangle3& t : triangles) {
    const auto base = static_cast<std::uint32_t>(soup.points.size());
    soup.points.insert(soup.points.end(), t.begin(), t.end());
    soup.triangles.push_back({base, base + 1, base + 2});
  }
  return ClosestPointIndex(soup);
}

} // namespace

TEST_CASE("A surface has no distance to itself") {
  TriangleSoup sphere;
  add_sphere(sphere, {5, 0, 0}, 1, 16);
  const ClosestPointIndex index(sphere);
  const DistanceBounds bounds = bound_distance(index, index, 1e-4, RunControl());
  CHECK(bounds.lower == 0);
  CHECK(bounds.upper <= 1e-4);
}

TEST_CASE("The farthest point may be far from every vertex") {
  const Vec3 a{0, 0, 0}, b{2, 0, 0};
  // A segment between two points: its middle is at distance 1 from both.
  const DistanceBounds bounds =
      bound_distance(index_of({{a, b, a}}), index_of({{a, a, a}, {b, b, b}}), 1e-3, RunControl());
  CHECK(bounds.lower <= 1);
  CHECK(bounds.upper >= 1);
  CHECK(bounds.upper - bounds.lower <= 1.001e-3);
  CHECK(distance(bounds.farthest, {1, 0, 0}) < 1e-3);
}

TEST_CASE("A box inside of a box: the corner of the outer one is farthest, and the way back is another") {
  TriangleSoup inner, outer;
  add_box(inner, {0, 0, 0}, {1, 1, 1});
  add_box(outer, {-1, -1, -1}, {2, 2, 3});
  const ClosestPointIndex in(inner), out(outer);
  const DistanceBounds there = bound_distance(out, in, 0.01, RunControl());
  CHECK(there.lower == doctest::Approx(std::sqrt(6.0)));
  CHECK(there.upper >= std::sqrt(6.0));
  CHECK(there.upper <= std::sqrt(6.0) + 0.0101);
  const DistanceBounds back = bound_distance(in, out, 0.01, RunControl());
  // From the middle of the inner box's top, 1.5 to the sides and 2 to the top; from its corners only 1.
  CHECK(back.lower <= 1.5);
  CHECK(back.upper >= 1.5);
  CHECK(back.upper - back.lower <= 0.0101);
}

TEST_CASE("No sampled point exceeds the upper bound, none is needed beyond the lower one") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    TriangleSoup from, to;
    add_torus(from, {}, 1, 0.3, 12);
    add_torus(to, {}, 1, 0.3, 9);
    for (Vec3& p : from.points) p += 0.1 * random.unit() * random.direction();
    const ClosestPointIndex a(from), b(to);
    const double precision = 2e-3;
    const DistanceBounds bounds = bound_distance(a, b, precision, RunControl());
    CHECK(bounds.upper - bounds.lower <= precision * 1.001);
    CHECK(b.distance(bounds.farthest) >= bounds.lower);
    CHECK(a.distance(bounds.farthest) < 1e-12);
    double sampled = 0;
    for (int i = 0; i < 4000; ++i) {
      const Triangle3 t = from.triangle(random.below(from.triangles.size()));
      double u = random.unit(), v = random.unit();
      if (u + v > 1) u = 1 - u, v = 1 - v;
      sampled = std::max(sampled, b.distance(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0])));
    }
    CHECK(sampled <= bounds.upper);
    CHECK(sampled >= 0.8 * bounds.lower);
  }
}

TEST_CASE("Threads change no bit, an abandoned control proves nothing") {
  TriangleSoup from, to;
  add_sphere(from, {}, 1, 40);
  add_sphere(to, {0.01, 0.02, 0}, 1.03, 11);
  const ClosestPointIndex a(from), b(to);
  RunControl control;
  const DistanceBounds first = bound_distance(a, b, 1e-3, control);
  for (const unsigned threads : {1u, 2u, 7u}) {
    const ThreadLimit limit(threads);
    const DistanceBounds again = bound_distance(a, b, 1e-3, control);
    CHECK(again.lower == first.lower);
    CHECK(again.upper == first.upper);
    CHECK(again.farthest == first.farthest);
  }
  control.abandon();
  const DistanceBounds nothing = bound_distance(a, b, 1e-3, control);
  CHECK(nothing.lower == 0);
  CHECK(nothing.upper == Box3::inf);
}

TEST_CASE("Nothing is at no distance, and infinitely far from what there is") {
  const ClosestPointIndex nothing = index_of({}), something = index_of({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}});
  const DistanceBounds from_nothing = bound_distance(nothing, something, 0.1, RunControl());
  CHECK(from_nothing.lower == 0);
  CHECK(from_nothing.upper == 0);
  const DistanceBounds to_nothing = bound_distance(something, nothing, 0.1, RunControl());
  CHECK(std::isinf(to_nothing.lower));
  CHECK(std::isinf(to_nothing.upper));
}
