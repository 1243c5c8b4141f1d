// Condition 3 on a tetrahedron that follows two parallel walls, and on one turned as in Figure 4.
#include "criteria/orientation.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

constexpr double everywhere = 100;

/// Two parallel walls: +1 on z = 1, -1 on z = 0.
struct Walls {
  std::vector<Vec3> positions;
  std::vector<std::int8_t> labels;

  Walls() {
    for (int x = -20; x <= 20; ++x) {
      for (int y = -20; y <= 20; ++y) {
        for (const int label : {-1, +1}) {
          positions.push_back({0.25 * x, 0.25 * y, label > 0 ? 1.0 : 0.0});
          labels.push_back(static_cast<std::int8_t>(label));
        }
      }
    }
  }
};

} // namespace

TEST_CASE("a tetrahedron between the walls is well oriented") {
  const Walls walls;
  const NearestSample samples(walls.positions, walls.labels);
  const std::array<Vec3, 4> p{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0.3, 0.3, 1}};
  const OrientationVerdict verdict = check_orientation(p, {-1, -1, -1, 1}, 0.7, everywhere, samples);
  CHECK_FALSE(verdict.misoriented);
  for (const OrientationTest& test : verdict.tests) CHECK(test.good());
}

TEST_CASE("a tetrahedron whose zero set stands across the walls is misoriented") {
  const Walls walls;
  const NearestSample samples(walls.positions, walls.labels);
  const std::array<Vec3, 4> p{Vec3{0, 0, 0.4}, Vec3{0, 1, 0.5}, Vec3{1, 0, 0.5}, Vec3{1, 1, 0.8}};
  const std::array<double, 4> f{-1, -1, 1, 1};
  const OrientationVerdict verdict = check_orientation(p, f, 0.7, everywhere, samples);
  CHECK(verdict.misoriented);
  const OrientationTest& worst = verdict.tests[static_cast<std::size_t>(verdict.worst)];
  CHECK_FALSE(worst.good());
  for (const OrientationTest& test : verdict.tests) CHECK(worst.f * worst.label <= test.f * test.label);
}

TEST_CASE("the copy shrinks about the centroid") {
  const Walls walls;
  const NearestSample samples(walls.positions, walls.labels);
  const std::array<Vec3, 4> p{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}, Vec3{0, 0, 4}};
  const OrientationVerdict half = check_orientation(p, {-1, -1, -1, 1}, 0.5, everywhere, samples);
  CHECK(half.tests[0].shrunk == Vec3{0.5, 0.5, 0.5});
  CHECK(half.tests[2].shrunk == Vec3{2.5, 0.5, 0.5});
  CHECK(check_orientation(p, {-1, -1, -1, 1}, 1.0, everywhere, samples).tests[7].shrunk == p[3]);
}

TEST_CASE("samples out of reach are not asked") {
  const Walls walls;
  const NearestSample samples(walls.positions, walls.labels);
  // Upright across the walls' middle: misoriented for whoever sees them.
  const std::array<Vec3, 4> p{Vec3{0, 0, 0.4}, Vec3{0, 1, 0.5}, Vec3{1, 0, 0.5}, Vec3{1, 1, 0.8}};
  const OrientationVerdict blind = check_orientation(p, {-1, -1, 1, 1}, 0.7, 0.2, samples);
  CHECK_FALSE(blind.misoriented);
  CHECK(blind.worst == -1);
  for (const OrientationTest& test : blind.tests) CHECK_FALSE(test.asked());
  // Only the wall below is near the lower vertices.
  const OrientationVerdict half_blind = check_orientation(p, {-1, -1, 1, 1}, 0.7, 0.55, samples);
  CHECK(half_blind.misoriented);
  for (const OrientationTest& test : half_blind.tests) {
    const double d = test.label > 0 ? 1 - test.shrunk.z : test.shrunk.z;
    CHECK((!test.asked() || d <= 0.55));
  }
}
