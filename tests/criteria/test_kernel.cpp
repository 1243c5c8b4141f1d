// The visibility kernel: known bodies, the largest ball by enumeration, and what containment means for a
// collapse.
#include "criteria/kernel.h"

#include "criteria/stars.h"
#include "mesh/predicates.h"
#include "mesh/support.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Solves Mx = r by elimination.
std::optional<std::array<double, 4>> solve4(std::array<std::array<double, 4>, 4> m, std::array<double, 4> r) {
  for (std::size_t k = 0; k < 4; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < 4; ++i) {
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    }
    if (std::abs(m[pivot][k]) < 1e-12) return std::nullopt;
    std::swap(m[k], m[pivot]);
    std::swap(r[k], r[pivot]);
    for (std::size_t i = 0; i < 4; ++i) {
      if (i == k) continue;
      const double f = m[i][k] / m[k][k];
      for (std::size_t j = 0; j < 4; ++j) m[i][j] -= f * m[k][j];
      r[i] -= f * r[k];
    }
  }
  return std::array<double, 4>{r[0] / m[0][0], r[1] / m[1][1], r[2] / m[2][2], r[3] / m[3][3]};
}

/// The largest radius over all balls that touch four half-spaces and violate none.
double radius_by_enumeration(const std::vector<HalfSpace>& h) {
  double best = -Box3::inf;
  const std::size_t n = h.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        for (std::size_t l = k + 1; l < n; ++l) {
          std::array<std::array<double, 4>, 4> m{};
          std::array<double, 4> r{};
          std::size_t row = 0;
          for (const std::size_t at : {i, j, k, l}) {
            m[row] = {h[at].normal.x, h[at].normal.y, h[at].normal.z, -1};
            r[row++] = h[at].offset;
          }
          const auto x = solve4(m, r);
          if (!x || (*x)[3] <= best) continue;
          const Vec3 c{(*x)[0], (*x)[1], (*x)[2]};
          if (std::all_of(h.begin(), h.end(),
                          [&](const HalfSpace& s) { return s.slack(c) >= (*x)[3] - 1e-9; }))
            best = (*x)[3];
        }
      }
    }
  }
  return best;
}

/// Random bounded half-spaces: a cube, and planes that cut it.
std::vector<HalfSpace> random_half_spaces(std::size_t n, double reach, Random& random) {
  std::vector<HalfSpace> h{{{1, 0, 0}, -1},  {{-1, 0, 0}, -1}, {{0, 1, 0}, -1},
                           {{0, -1, 0}, -1}, {{0, 0, 1}, -1},  {{0, 0, -1}, -1}};
  while (h.size() < n) {
    const Vec3 v = random.in({{-1, -1, -1}, {1, 1, 1}});
    if (length(v) > 0.1) h.push_back({normalized(v), -reach * random.uniform()});
  }
  return h;
}

void check_polyhedron(const Kernel& kernel, const KernelPolyhedron& p, double tolerance) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::size_t corners = 0;
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    const auto& face = p.faces[f];
    const HalfSpace& h = kernel.half_spaces.at(p.source[f]);
    for (std::size_t k = 0; k < face.size(); ++k) {
      ++edges[{face[k], face[(k + 1) % face.size()]}];
      CHECK(std::abs(h.slack(p.vertices[face[k]])) <= tolerance);
    }
    corners += face.size();
  }
  for (const auto& [edge, count] : edges) {
    CHECK(count == 1);
    CHECK(edges.count({edge.second, edge.first}) == 1);
  }
  CHECK(p.vertices.size() + p.faces.size() == corners / 2 + 2);
  for (const Vec3 v : p.vertices) {
    for (const HalfSpace& h : kernel.half_spaces) CHECK(h.slack(v) >= -tolerance);
  }
}

} // namespace

TEST_CASE("the kernel of a convex one-ring is the whole of it") {
  const Kernel kernel = compute_kernel(octahedron_star());
  CHECK_FALSE(kernel.empty);
  CHECK(kernel.half_spaces.size() == 8);
  CHECK(kernel.facets.size() == 8);
  CHECK(length(kernel.center) < 1e-12);
  CHECK(kernel.inscribed_radius == doctest::Approx(1 / std::sqrt(3.0)));
  CHECK(kernel.witness.empty());
  CHECK(kernel.contains({0.3, 0.3, 0.3}));
  CHECK_FALSE(kernel.contains({0.5, 0.5, 0})); // on an edge
  CHECK_FALSE(kernel.contains({1, 0, 0}));
  CHECK_FALSE(kernel.contains({0.4, 0.4, 0.3}));
  const KernelPolyhedron p = kernel_polyhedron(kernel);
  CHECK(p.vertices.size() == 6);
  CHECK(p.faces.size() == 8);
  CHECK(p.volume == doctest::Approx(4.0 / 3));
  check_polyhedron(kernel, p, 1e-12);
}

TEST_CASE("the largest ball in a cube, a slab's corner, and a box that is far away") {
  std::vector<HalfSpace> cube{{{1, 0, 0}, 0},   {{-1, 0, 0}, -1}, {{0, 1, 0}, 0},
                              {{0, -1, 0}, -1}, {{0, 0, 1}, 0},   {{0, 0, -1}, -1}};
  InscribedBall ball = inscribed_ball(cube, {0, 0, 0}, 2);
  CHECK(ball.radius == doctest::Approx(0.5));
  CHECK(distance(ball.center, {0.5, 0.5, 0.5}) < 1e-12);
  // Twice each, and two more that only touch the ball.
  std::vector<HalfSpace> twice = cube;
  twice.insert(twice.end(), cube.begin(), cube.end());
  const Vec3 n = normalized({1, 1, 1});
  twice.push_back({n, dot(n, Vec3{0.5, 0.5, 0.5}) - 0.5});
  twice.push_back({-n, -dot(n, Vec3{0.5, 0.5, 0.5}) - 0.5});
  CHECK(inscribed_ball(twice, {0, 0, 0}, 2).radius == doctest::Approx(0.5));
  const Vec3 far{1e6, -3e6, 2e6};
  for (HalfSpace& h : cube) h.offset += dot(h.normal, far);
  ball = inscribed_ball(cube, far, 2);
  CHECK(ball.radius == doctest::Approx(0.5));
  CHECK(distance(ball.center, far + Vec3{0.5, 0.5, 0.5}) < 1e-8);
}

TEST_CASE("far from the origin and at any scale the kernel is the same") {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    EdgeStar star = octahedron_star();
    const Vec3 shift = scale * Vec3{1 << 20, -(1 << 21), 1 << 19};
    transform(star, scale, scale, shift);
    const Kernel kernel = compute_kernel(star);
    CHECK_FALSE(kernel.empty);
    CHECK(kernel.inscribed_radius == doctest::Approx(scale / std::sqrt(3.0)));
    CHECK(distance(kernel.center, shift) < 1e-8 * scale);
    CHECK(kernel_polyhedron(kernel).volume == doctest::Approx(4.0 / 3 * scale * scale * scale));
  }
}

TEST_CASE("a needle has a kernel as thin as itself") {
  for (const double thin : {1e-3, 1e-6, 1e-9}) {
    EdgeStar star = octahedron_star();
    transform(star, thin, 1, {});
    const Kernel kernel = compute_kernel(star);
    REQUIRE_FALSE(kernel.empty);
    CHECK(kernel.inscribed_radius == doctest::Approx(1 / std::sqrt(2 + 1 / (thin * thin))));
    CHECK(kernel.contains(kernel.center));
  }
}

TEST_CASE("facets that look past each other leave an empty kernel with its witness") {
  // Top and bottom change places: what the upper facets see lies below what the lower ones see.
  EdgeStar star = octahedron_star();
  std::swap(star.vertices[6].position, star.vertices[7].position);
  const Kernel kernel = compute_kernel(star);
  REQUIRE(kernel.empty);
  CHECK(kernel.inscribed_radius <= 0);
  CHECK(kernel.missing_slack == doctest::Approx(1 / std::sqrt(3.0)));
  REQUIRE(kernel.witness.size() >= 2);
  REQUIRE(kernel.witness.size() <= 4);
  // The witness alone misses a common point by as much.
  std::vector<HalfSpace> few;
  for (const std::uint32_t i : kernel.witness) few.push_back(kernel.half_spaces[i]);
  CHECK(inscribed_ball(few, kernel.center, 2).radius == doctest::Approx(-kernel.missing_slack));
  CHECK(kernel_polyhedron(kernel).vertices.empty());
}

TEST_CASE("a facet without a plane empties the kernel") {
  EdgeStar star = octahedron_star();
  star.vertices[6].position = {0.5, 0.5, 0};
  const Kernel kernel = compute_kernel(star);
  CHECK(kernel.empty);
  CHECK(kernel.witness.size() == 1);
  CHECK_FALSE(kernel.contains({0, 0, 0}));
}

TEST_CASE("the largest ball agrees with enumeration, whether there is one or not") {
  Random random(7);
  std::size_t full = 0, empty = 0;
  for (int i = 0; i < 120; ++i) {
    const auto h = random_half_spaces(6 + random.below(8), i % 2 ? 0.9 : -0.5, random);
    const double expected = radius_by_enumeration(h);
    const InscribedBall ball = inscribed_ball(h, {0, 0, 0}, 2);
    CHECK(ball.radius == doctest::Approx(expected).epsilon(1e-7));
    ++(expected > 0 ? full : empty);
    if (expected > 0) continue;
    std::vector<HalfSpace> few;
    for (const std::uint32_t k : ball.tight) few.push_back(h[k]);
    CHECK(few.size() <= 4);
    CHECK(inscribed_ball(few, {0, 0, 0}, 2).radius == doctest::Approx(ball.radius).epsilon(1e-6));
  }
  CHECK(full > 20);
  CHECK(empty > 20);
}

TEST_CASE("a hundred half-spaces about a sphere") {
  Random random(11);
  std::vector<HalfSpace> h;
  while (h.size() < 100) {
    const Vec3 v = random.in({{-1, -1, -1}, {1, 1, 1}});
    if (length(v) > 0.1 && length(v) < 1) h.push_back({normalized(v), -0.3});
  }
  const InscribedBall ball = inscribed_ball(h, {0.1, 0.2, -0.1}, 1);
  CHECK(ball.radius == doctest::Approx(0.3).epsilon(1e-9));
  CHECK(length(ball.center) < 1e-9);
}

TEST_CASE("kernels of random stars: inside means that every tetrahedron stays positive") {
  Random random(3);
  std::size_t inside = 0, outside = 0, full = 0, empty = 0;
  for (const EdgeStar& star : random_stars(150, 7, 5)) {
    const Kernel kernel = compute_kernel(star);
    const double enumerated = kernel.half_spaces.size() < 26 ? radius_by_enumeration(kernel.half_spaces) : 0;
    if (kernel.half_spaces.size() < 26) CHECK(kernel.empty == (enumerated <= 1e-10));
    ++(kernel.empty ? empty : full);
    Box3 box;
    for (const auto& f : kernel.facets) {
      for (const Vec3 p : f) box.add(p);
    }
    for (int i = 0; i < 40; ++i) {
      const Vec3 x = i == 0 ? kernel.center : random.in(box);
      bool positive = true;
      for (const EdgeStar::StarTet& t : star.tets) {
        if (t.ring()) continue;
        const auto p = star.positions_after(t, x);
        positive = positive && orientation(p[0], p[1], p[2], p[3]) > 0;
      }
      CHECK(kernel.contains(x) == positive);
      if (kernel.empty) CHECK_FALSE(positive);
      ++(positive ? inside : outside);
    }
    if (!kernel.empty) {
      CHECK(kernel.contains(kernel.center));
      check_polyhedron(kernel, kernel_polyhedron(kernel), 1e-9);
    }
    const Kernel again = compute_kernel(star);
    CHECK(again.center == kernel.center);
    CHECK(again.inscribed_radius == kernel.inscribed_radius);
    CHECK(again.witness == kernel.witness);
  }
  CHECK(inside > 100);
  CHECK(outside > 100);
  CHECK(full > 20);
  CHECK(empty > 20);
}

TEST_CASE("squeezing a star empties no kernel and fills none") {
  std::size_t full = 0, empty = 0;
  std::vector<EdgeStar> stars = random_stars(80, 5, 13);
  // Coplanar facets in all directions: kernels that touch, or are flat.
  const Grown lattice = grow({{-3, -3, -3}, {6, 6, 6}}, lattice_points(4, 2));
  const auto edges = inner_edges(lattice.complex);
  for (std::size_t i = 0; i < edges.size(); i += 5)
    stars.push_back(star_of(lattice.complex, edges[i].first, edges[i].second));
  for (const EdgeStar& star : stars) {
    const Kernel kernel = compute_kernel(star);
    ++(kernel.empty ? empty : full);
    for (const double thin : {0.01, 1e-6}) {
      EdgeStar squeezed = star;
      transform(squeezed, thin, 1, {});
      CHECK(compute_kernel(squeezed).empty == kernel.empty);
    }
  }
  CHECK(full > 50);
  CHECK(empty > 20);
}
