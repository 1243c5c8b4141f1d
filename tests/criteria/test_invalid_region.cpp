// Ψ: the situations of Figures 9 and 12 in space, and direct evaluation of the sample at random targets.
#include "criteria/invalid_region.h"

#include "criteria/stars.h"
#include "mesh/support.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Two tetrahedra on the facet ABC at z = 0, the ends of the edge above it; ABC has the values f, the ends 1.
EdgeStar facet_star(std::array<double, 3> f) {
  EdgeStar star = make_star({{0, 0, 3}, {0.2, 0, 4}, {2, 0, 0}, {-1, 2, 0}, {-1, -2, 0}, {0, 0, -3}},
                            {{0, 2, 3, 4}, {0, 1, 2, 3}});
  for (std::size_t k = 0; k < 3; ++k) star.vertices[2 + k].value = f[k];
  return star;
}

EdgeStar::StarSample sample_at(Vec3 p, int label) {
  return {SampleId(7), p, static_cast<std::int8_t>(label)};
}

/// Barycentric coordinates of e in the tetrahedron after the collapse, in the order of its vertices.
std::array<double, 4> weights(const EdgeStar& star, const EdgeStar::StarTet& t, Vec3 target, Vec3 e) {
  const auto p = star.positions_after(t, target);
  std::array<double, 4> w{};
  const double volume = dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
  for (std::size_t k = 0; k < 4; ++k) {
    auto q = p;
    q[k] = e;
    w[k] = dot(cross(q[1] - q[0], q[2] - q[0]), q[3] - q[0]) / volume;
  }
  return w;
}

/// How clearly the sample is inside the tetrahedron and misclassified: the least of the quantities that must
/// be positive.
double violation(const EdgeStar& star, const EdgeStar::StarTet& t, const EdgeStar::StarSample& s, Vec3 target,
                 double target_value, double margin) {
  const auto w = weights(star, t, target, s.position);
  double f = 0;
  for (std::size_t k = 0; k < 4; ++k) f += w[k] * (t.v[k] < 2 ? target_value : star.vertices[t.v[k]].value);
  const double inside = *std::min_element(w.begin(), w.end());
  return std::min(inside, margin - s.label * f);
}

} // namespace

TEST_CASE("A, B, C of one label, as on top of Figure 9: m is parallel to ABC") {
  const EdgeStar star = facet_star({1, 1, 1});
  const auto sample = sample_at({0, 0, 1}, -1);
  const InvalidRegion region = invalid_region(star, star.tets[0], sample, -1, 0);
  REQUIRE(region.half_spaces.size() == 4);
  CHECK(region.tet == star.tets[0].id);
  CHECK(region.sample == sample.id);
  // On the axis Z lies halfway: E at height 1 is on the side of ABC once T is higher than 2.
  CHECK_FALSE(region.contains({0, 0, 0.5}));
  CHECK_FALSE(region.contains({0, 0, 1.99}));
  CHECK(region.contains({0, 0, 2.01}));
  CHECK(region.contains({0, 0, 100}));
  CHECK(std::abs(region.half_spaces[3].normal.z) == doctest::Approx(1));
  // The planes through E: on that of AC and E the cone ends.
  CHECK_FALSE(region.contains({30, 0, 3}));
  // With a margin the zero set must be nearer to ABC: f(E) = 1 − 2/h <= −0.2 up to h = 5/3.
  const InvalidRegion strict = invalid_region(star, star.tets[0], sample, -1, 0.2);
  CHECK_FALSE(strict.contains({0, 0, 1.66}));
  CHECK(strict.contains({0, 0, 1.67}));
}

TEST_CASE("A of another label than B and C, as at the bottom of Figure 9: m is parallel to EY") {
  const EdgeStar star = facet_star({-1, 1, 1});
  const auto sample = sample_at({0, 0, 1}, 1);
  const InvalidRegion region = invalid_region(star, star.tets[0], sample, -1, 0);
  REQUIRE(region.half_spaces.size() == 4);
  // n, the extreme zero set, is the plane of E and the fixed zeros on AB and AC; m is parallel to it, where
  // the same function has the value of T: that of A.
  const HalfSpace& m = region.half_spaces[3];
  const double apart = m.slack(sample.position);
  CHECK(std::abs(apart) > 0.1);
  CHECK(m.slack({0.5, 1, 0}) == doctest::Approx(apart));
  CHECK(m.slack({0.5, -1, 0}) == doctest::Approx(apart));
  CHECK(m.slack({2, 0, 0}) == doctest::Approx(0));
}

TEST_CASE("nothing is invalid where every vertex has the sample's label") {
  const EdgeStar star = facet_star({1, 1, 1});
  const InvalidRegion region = invalid_region(star, star.tets[0], sample_at({0, 0, 1}, 1), 1, 0);
  Random random(1);
  for (int i = 0; i < 200; ++i) CHECK_FALSE(region.contains(random.in({{-9, -9, -9}, {9, 9, 9}})));
}

TEST_CASE("a sample in the plane of the facet has no region") {
  const EdgeStar star = facet_star({1, 1, 1});
  CHECK(invalid_region(star, star.tets[0], sample_at({0.1, 0.1, 0}, -1), -1, 0).empty());
}

TEST_CASE("embedded Z: the cone that keeps E inside the tetrahedron of the other side, as in Figure 12") {
  EdgeStar star = facet_star({0, 1, 1});
  star.form = ZeroForm::embedded;
  star.tets[0].side = 1;
  CHECK(invalid_region(star, star.tets[0], sample_at({0, 0, 1}, 1), 0, 0).empty());
  const InvalidRegion region = invalid_region(star, star.tets[0], sample_at({0, 0, 1}, -1), 0, 0);
  CHECK(region.half_spaces.size() == 3);
  CHECK(region.contains({0, 0, 1.01}));
  CHECK(region.contains({0, 0, 50}));
  CHECK_FALSE(region.contains({0, 0, 0.99}));
  // From A = (2, 0, 0) through E: beyond it the ray to T would leave over the edge BC or the corner.
  CHECK(region.contains({-0.9, 0, 1.5}));
  CHECK_FALSE(region.contains({-1.1, 0, 1.5}));
}

TEST_CASE("a target is in Ψ exactly when the sample is misclassified in the tetrahedron there") {
  Random random(31);
  std::size_t inside = 0, outside = 0;
  for (int i = 0; i < 300; ++i) {
    const auto label = [&random] { return static_cast<double>(random.below(3)) - 1; };
    EdgeStar star = facet_star({label(), label(), label()});
    const double target_value = label(), margin = random.below(2) ? 0.2 * random.uniform() : 0.0;
    const auto sample = sample_at(random.in({{-1, -1, 0.1}, {1, 1, 1.5}}), random.below(2) ? 1 : -1);
    const InvalidRegion region = invalid_region(star, star.tets[0], sample, target_value, margin);
    for (int k = 0; k < 100; ++k) {
      const Vec3 target = random.in({{-4, -4, 0.2}, {4, 4, 6}});
      const double v = violation(star, star.tets[0], sample, target, target_value, margin);
      if (std::abs(v) < 1e-9) continue;
      CHECK(region.contains(target) == (v > 0));
      ++(v > 0 ? inside : outside);
    }
  }
  CHECK(inside > 500);
  CHECK(outside > 500);
}

TEST_CASE("a box is inside when all its corners are") {
  const EdgeStar star = facet_star({1, 1, 1});
  const InvalidRegion cone = invalid_region(star, star.tets[0], sample_at({0, 0, 1}, -1), -1, 0);
  const InvalidRegion ball = invalid_region({0.5, 0, 3}, 0.5, 1);
  Random random(8);
  std::size_t inside = 0;
  for (const InvalidRegion& region : {cone, ball}) {
    for (int i = 0; i < 500; ++i) {
      const Vec3 c = random.in({{-2, -2, 0}, {2, 2, 6}}), e = random.in({{0, 0, 0}, {1, 1, 1}});
      const Box3 box{c, c + e};
      bool corners = true;
      for (int k = 0; k < 8; ++k) {
        const Vec3 corner{k & 1 ? box.hi.x : box.lo.x, k & 2 ? box.hi.y : box.lo.y,
                          k & 4 ? box.hi.z : box.lo.z};
        corners = corners && region.contains(corner);
      }
      CHECK(region.contains_box(box) == corners);
      inside += corners;
    }
  }
  CHECK(inside > 30);
  CHECK_FALSE(InvalidRegion{}.contains({0, 0, 0}));
  CHECK_FALSE(InvalidRegion{}.contains_box({{0, 0, 0}, {1, 1, 1}}));
}

TEST_CASE("certified mode: no target in the ball brings the violating point back into Ω") {
  // Ω is the slab |z| <= 0.5: d − δ = |z| − 0.5.
  const Vec3 p{1, 0, 0}, q{0, 1, 0}, target{0.3, 0.2, 2};
  const double weight = 0.4;
  const auto point = [&](Vec3 t) { return weight * t + 0.3 * p + 0.3 * q; };
  const double excess = point(target).z - 0.5;
  REQUIRE(excess > 0);
  const InvalidRegion region = invalid_region(target, weight, excess);
  CHECK(region.contains(target));
  Random random(4);
  std::size_t inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 t = target + random.in({{-2, -2, -2}, {2, 2, 2}});
    if (!region.contains(t)) continue;
    CHECK(point(t).z > 0.5 - 1e-12);
    ++inside;
  }
  CHECK(inside > 20);
  CHECK_FALSE(region.contains(target - Vec3{0, 0, excess / weight + 1e-6}));
}
