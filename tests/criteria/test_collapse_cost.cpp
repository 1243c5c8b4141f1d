// The error of a collapse: planes with known optima, and its minimum over half-spaces against enumeration.
#include "criteria/collapse_cost.h"

#include "criteria/closest_in_half_spaces.h"
#include "criteria/stars.h"
#include "mesh/support.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// A triangle in the plane through p with normal n.
Triangle3 triangle_in(Vec3 p, Vec3 n) {
  const Vec3 u = normalized(cross(n, std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 v = cross(normalized(n), u);
  return {p, p + u, p + v};
}

EdgeStar corner_star(Vec3 corner) {
  EdgeStar star = octahedron_star();
  star.cost_facets = {triangle_in(corner, {1, 0, 0}), triangle_in(corner, {0, 1, 0}),
                      triangle_in(corner, {0, 0, 1})};
  return star;
}

double squared_distances(const EdgeStar& star, Vec3 x) {
  double sum = 0;
  for (const Triangle3& t : star.cost_facets) {
    const double d = dot(normalized(cross(t[1] - t[0], t[2] - t[0])), x - t[0]);
    sum += d * d;
  }
  return sum;
}

/// The nearest point by trying all sets of up to three planes.
std::optional<Vec3> closest_by_enumeration(const std::vector<HalfSpace>& h, Vec3 p) {
  std::optional<Vec3> best;
  const auto offer = [&](Vec3 x) {
    if (!is_finite(x)) return;
    if (!std::all_of(h.begin(), h.end(), [x](const HalfSpace& s) { return s.slack(x) >= -1e-9; })) return;
    if (!best || distance(x, p) < distance(*best, p)) best = x;
  };
  offer(p);
  for (std::size_t i = 0; i < h.size(); ++i) {
    offer(p - h[i].slack(p) * h[i].normal);
    for (std::size_t j = i + 1; j < h.size(); ++j) {
      const Vec3 a = h[i].normal, b = h[j].normal;
      const double ab = dot(a, b), det = 1 - ab * ab;
      if (det < 1e-9) continue;
      const double ra = -h[i].slack(p), rb = -h[j].slack(p);
      offer(p + ((ra - ab * rb) / det) * a + ((rb - ab * ra) / det) * b);
      for (std::size_t k = j + 1; k < h.size(); ++k) {
        const Vec3 c = h[k].normal;
        const double volume = dot(a, cross(b, c));
        if (std::abs(volume) < 1e-9) continue;
        offer((h[i].offset * cross(b, c) + h[j].offset * cross(c, a) + h[k].offset * cross(a, b)) / volume);
      }
    }
  }
  return best;
}

} // namespace

TEST_CASE("three planes through a point: no error there, squared distances elsewhere") {
  const Vec3 corner{0.2, -0.1, 0.05};
  const CollapseCost cost(corner_star(corner));
  CHECK(cost(corner) < 1e-15);
  CHECK(distance(cost.optimum(), corner) < 1e-5);
  CHECK(cost(corner + Vec3{1, 2, -3}) == doctest::Approx(14));
}

TEST_CASE("in directions without error the optimum stays with the edge's middle") {
  EdgeStar star = octahedron_star();
  star.cost_facets = {triangle_in({0, 0, 0.1}, {0, 0, 2})};
  const CollapseCost plane(star);
  CHECK(distance(plane.optimum(), {0, 0, 0.1}) < 1e-5);
  star.cost_facets.push_back({Vec3{1, 1, 1}, Vec3{2, 2, 2}, Vec3{3, 3, 3}}); // no plane
  CHECK(distance(CollapseCost(star).optimum(), plane.optimum()) == 0);
  star.cost_facets.clear();
  const CollapseCost none(star);
  CHECK(none.optimum() == Vec3{0, 0, 0});
  CHECK(none({5, 5, 5}) == 0);
}

TEST_CASE("the error is the sum of squared distances, also far from the origin and at any scale") {
  Random random(5);
  for (const double scale : {1e-8, 1.0, 1e8}) {
    EdgeStar star = octahedron_star();
    for (int i = 0; i < 12; ++i) {
      const Box3 box{{-1, -1, -1}, {1, 1, 1}};
      star.cost_facets.push_back({random.in(box), random.in(box), random.in(box)});
    }
    transform(star, scale, scale, scale * Vec3{1 << 20, 0, -(1 << 20)});
    const CollapseCost cost(star);
    const Vec3 middle = 0.5 * (star.vertices[0].position + star.vertices[1].position);
    for (int i = 0; i < 20; ++i) {
      const Vec3 x = middle + scale * random.in({{-2, -2, -2}, {2, 2, 2}});
      CHECK(cost(x) == doctest::Approx(squared_distances(star, x)).epsilon(1e-6));
      CHECK(cost(x) >= cost(cost.optimum()) * (1 - 1e-4));
      const Vec3 y = middle + scale * random.in({{-2, -2, -2}, {2, 2, 2}});
      CHECK(cost(y) >= cost(x) + dot(cost.gradient(x), y - x) - 1e-9 * scale * scale);
    }
  }
}

TEST_CASE("a half-space beyond the optimum holds the minimum on its plane") {
  const CollapseCost cost(corner_star({0, 0, 0}));
  const std::vector<HalfSpace> wall{{{1, 0, 0}, 0.5}};
  REQUIRE(cost.minimum(wall));
  CHECK(distance(*cost.minimum(wall), {0.5, 0, 0}) < 1e-6);
  const std::vector<HalfSpace> wedge{
      {{1, 0, 0}, 0.5}, {{-1, 0, 0}, -0.7}, {{0, 1, 0}, 0.25}, {{0, 0, 1}, -9}};
  REQUIRE(cost.minimum(wedge));
  CHECK(distance(*cost.minimum(wedge), {0.5, 0.25, 0}) < 1e-6);
  CHECK_FALSE(cost.minimum(std::vector<HalfSpace>{{{1, 0, 0}, 0.5}, {{-1, 0, 0}, -0.4}}));
  CHECK(cost.minimum({}) == cost.optimum());
}

TEST_CASE("the nearest point of half-spaces agrees with enumeration") {
  Random random(17);
  std::size_t found = 0, none = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<HalfSpace> h;
    const std::size_t n = 1 + random.below(14);
    while (h.size() < n) {
      const Vec3 v = random.in({{-1, -1, -1}, {1, 1, 1}});
      if (length(v) > 0.1) h.push_back({normalized(v), random.uniform() - (i % 2 ? 0.9 : 0.6)});
    }
    if (i % 5 == 0) h.insert(h.end(), h.begin(), h.begin() + static_cast<std::ptrdiff_t>(n / 2)); // twice
    const Vec3 p = random.in({{-2, -2, -2}, {2, 2, 2}});
    const auto expected = closest_by_enumeration(h, p);
    const auto x = closest_in_half_spaces(h, p);
    REQUIRE(x.has_value() == expected.has_value());
    ++(x ? found : none);
    if (!x) continue;
    CHECK(distance(*x, p) == doctest::Approx(distance(*expected, p)).epsilon(1e-7));
    for (const HalfSpace& s : h) CHECK(s.slack(*x) >= -1e-10);
  }
  CHECK(found > 50);
  CHECK(none > 50);
}

TEST_CASE("no point of a kernel has less error than the minimum over it") {
  Random random(23);
  std::size_t bound = 0;
  for (EdgeStar& star : random_stars(80, 5, 9)) {
    const Kernel kernel = compute_kernel(star);
    if (kernel.empty) continue;
    for (int i = 0; i < 6; ++i) {
      const Vec3 p = random.in({{-1, -1, -1}, {1, 1, 1}});
      star.cost_facets.push_back(triangle_in(p, random.in({{-1, -1, -1}, {1, 1, 1}})));
    }
    const CollapseCost cost(star);
    const auto x = cost.minimum(kernel.half_spaces);
    REQUIRE(x);
    Box3 box;
    for (const Triangle3& f : kernel.facets) {
      for (const Vec3 p : f) box.add(p);
    }
    for (const HalfSpace& h : kernel.half_spaces) CHECK(h.slack(*x) >= -1e-9);
    for (int i = 0; i < 300; ++i) {
      // From the box, and near the minimum.
      const Vec3 y = i % 2 ? random.in(box) : *x + 0.1 * random.in({{-1, -1, -1}, {1, 1, 1}});
      if (kernel.contains(y)) CHECK(cost(y) >= cost(*x) - 1e-4 * (1 + cost(*x)));
    }
    bound += distance(*x, cost.optimum()) > 1e-6;
  }
  CHECK(bound > 5);
}
