// Whole runs on closed parts that overlap or touch: the union, joined where Ω joins it.
#include "run/complete_run.h"
#include "run/input_walls.h"
#include "run/voxel_soup.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

using namespace isoscope;
using namespace isoscope::test;
using isoscope::testing::add_box;
using isoscope::testing::add_sphere;

namespace {

std::unique_ptr<CompleteRun> run_soup(TriangleSoup soup, double delta,
                                      SidesMode sides = SidesMode::automatic) {
  auto run = std::make_unique<CompleteRun>(std::move(soup), delta);
  run->parameters.input = "soup";
  run->parameters.effort = 0;
  run->parameters.sides = sides;
  run->run();
  return run;
}

void check_run(const CompleteRun& run, std::size_t components, long euler_characteristic) {
  REQUIRE_MESSAGE(run.result.has_value(), (run.error ? run.error->line() : ""));
  const Certificate& c = run.result->certificate;
  CHECK_MESSAGE(c.holds(), (c.failures.empty() ? "" : c.failures.front()));
  CHECK(c.components == components);
  CHECK(c.euler_characteristic == euler_characteristic);
}

TriangleSoup overlapping_boxes() {
  TriangleSoup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {0.6, 0.3, 0.2}, {1.6, 1.3, 1.2});
  return soup;
}

/// A block along y with a groove in its upper face, 0.8 wide and 0.7 deep, that ends in an edge at z = 0.3.
void add_grooved_block(TriangleSoup& soup) {
  const std::array<std::array<double, 2>, 7> profile{
      {{-1, 0}, {1, 0}, {1, 1}, {0.4, 1}, {0, 0.3}, {-0.4, 1}, {-1, 1}}};
  const auto n = static_cast<std::uint32_t>(profile.size());
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (const double y : {0.0, 2.0})
    for (const auto& [x, z] : profile) soup.points.push_back({x, y, z});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = first + i, b = first + (i + 1) % n;
    soup.triangles.push_back({a, b + n, b});
    soup.triangles.push_back({a, a + n, b + n});
  }
  // The profile as seen from the groove's edge.
  for (std::uint32_t i = 5; i + 1 < n + 4; ++i) {
    const std::uint32_t a = first + i % n, b = first + (i + 1) % n, edge = first + 4;
    soup.triangles.push_back({edge, a, b});
    soup.triangles.push_back({edge + n, b + n, a + n});
  }
}

void turn_inside_out(TriangleSoup& soup, std::size_t first_triangle) {
  for (std::size_t t = first_triangle; t < soup.triangles.size(); ++t)
    std::swap(soup.triangles[t][1], soup.triangles[t][2]);
}

/// A cone of 32 sides that stands on its tip.
void add_cone_on_tip(TriangleSoup& soup, Vec3 tip, double radius, double height) {
  constexpr std::uint32_t n = 32;
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back(tip);
  soup.points.push_back(tip + Vec3{0, 0, height});
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    soup.points.push_back(tip + Vec3{radius * std::cos(angle), radius * std::sin(angle), height});
    const std::uint32_t a = first + 2 + i, b = first + 2 + (i + 1) % n;
    soup.triangles.push_back({first, b, a});
    soup.triangles.push_back({first + 1, a, b});
  }
}

/// A random set of voxels.
struct Voxels {
  int size;
  std::vector<char> solid;
  Voxels(int n, unsigned seed, double share) : size(n), solid(static_cast<std::size_t>(n * n * n)) {
    std::mt19937 random(seed);
    for (char& s : solid) s = random() < share * 4294967296.0;
  }
  bool at(int x, int y, int z) const {
    const auto inside = [&](int i) { return i >= 0 && i < size; };
    return inside(x) && inside(y) && inside(z) &&
           solid[static_cast<std::size_t>((x * size + y) * size + z)] != 0;
  }
  TriangleSoup surface() const {
    return voxel_surface({size, size, size}, [&](int x, int y, int z) { return at(x, y, z); });
  }
  /// Of the closed cubes together: by counting their corners, edges, faces and themselves.
  long euler_characteristic() const {
    std::set<std::array<int, 3>> cells; // by the doubled coordinates of their centres
    for (int x = 0; x < size; ++x)
      for (int y = 0; y < size; ++y)
        for (int z = 0; z < size; ++z)
          for (int k = 0; at(x, y, z) && k < 27; ++k)
            cells.insert({2 * x + k % 3, 2 * y + k / 3 % 3, 2 * z + k / 9});
    long sum = 0;
    for (const auto& c : cells) sum += (c[0] % 2 + c[1] % 2 + c[2] % 2) % 2 == 0 ? 1 : -1;
    return sum;
  }
  /// Connected sets of solid cubes that share at least a corner, or of empty ones that share a face.
  std::size_t components(bool of_solid) const {
    std::set<std::array<int, 3>> left;
    for (int x = -1; x <= size; ++x)
      for (int y = -1; y <= size; ++y)
        for (int z = -1; z <= size; ++z)
          if (at(x, y, z) == of_solid) left.insert({x, y, z});
    std::size_t count = 0;
    for (; !left.empty(); ++count) {
      std::vector<std::array<int, 3>> stack{*left.begin()};
      left.erase(left.begin());
      while (!stack.empty()) {
        const auto [x, y, z] = stack.back();
        stack.pop_back();
        for (int k = 0; k < 27; ++k) {
          const int dx = k % 3 - 1, dy = k / 3 % 3 - 1, dz = k / 9 - 1;
          if (!of_solid && std::abs(dx) + std::abs(dy) + std::abs(dz) != 1) continue;
          const std::array<int, 3> next{x + dx, y + dy, z + dz};
          if (left.erase(next) > 0) stack.push_back(next);
        }
      }
    }
    return count;
  }
};

} // namespace

TEST_CASE("two boxes that overlap are one body of few vertices, also with a facet twice or turned") {
  TriangleSoup twice = overlapping_boxes(), turned = overlapping_boxes();
  twice.triangles.push_back(twice.triangles[7]);
  std::swap(turned.triangles[7][0], turned.triangles[7][1]);
  std::vector<Vec3> without;
  for (const TriangleSoup& soup : {overlapping_boxes(), twice, turned}) {
    const auto run = run_soup(soup, 0.1);
    check_run(*run, 1, 2);
    if (without.empty()) without = run->result->mesh.points;
    if (soup.triangles.size() > turned.triangles.size()) {
      // A facet that is there twice changes nothing at all.
      CHECK(run->result->mesh.points == without);
      CHECK(run->result->normals.oriented);
    }
    CHECK(run->result->mesh.points.size() < 40);
    CHECK(run->scene->expected.source == "the outer boundary of Ω");
    CHECK(run->scene->thickening_note.find("overlap") != std::string::npos);
  }
}

TEST_CASE("three boxes that overlap each other, and a table of five, are one body each") {
  TriangleSoup three = overlapping_boxes();
  add_box(three, {0.3, 0.5, 0.6}, {1.3, 0.9, 1.8});
  check_run(*run_soup(three, 0.1), 1, 2);
  TriangleSoup table;
  add_box(table, {0, 0, 0.8}, {1, 0.8, 1});
  for (const double x : {0.05, 0.75})
    for (const double y : {0.05, 0.55}) add_box(table, {x, y, 0}, {x + 0.2, y + 0.2, 0.9});
  check_run(*run_soup(table, 0.05), 1, 2);
}

TEST_CASE("bodies that touch in one point are joined there, and the wedge between them need not be covered") {
  TriangleSoup cone;
  add_cone_on_tip(cone, {0, 0, 0.3}, 0.6, 1);
  add_box(cone, {-1, -1, 0}, {1, 1, 0.3});
  const auto on_tip = run_soup(cone, 0.04);
  check_run(*on_tip, 1, 2);
  CHECK(on_tip->scene->thickening_note.find("touch, near (0, 0, 0.3)") != std::string::npos);

  TriangleSoup ball;
  testing::add_sphere(ball, {0, 0, 1.5}, 1, 16);
  add_box(ball, {-1, -1, -0.5}, {1, 1, 0.5});
  const auto tangent = run_soup(ball, 0.06);
  check_run(*tangent, 1, 2);
  CHECK(!tangent->result->certificate.gap_note.empty());
}

TEST_CASE("the same body twice is one body") {
  TriangleSoup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  check_run(*run_soup(soup, 0.08), 1, 2);
}

TEST_CASE("a body inside another is a cavity, or nothing with --sides winding") {
  TriangleSoup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7});
  check_run(*run_soup(soup, 0.06), 2, 4);
  check_run(*run_soup(soup, 0.06, SidesMode::winding), 1, 2);
}

TEST_CASE("overlapping bodies with cavities keep what is a cavity of all of them") {
  TriangleSoup soup;
  add_box(soup, {0, 0, 0}, {2, 1, 1});
  add_box(soup, {0.8, -0.1, -0.1}, {3, 1.1, 1.1});
  const std::size_t bodies = soup.triangles.size();
  add_box(soup, {0.9, 0.3, 0.3}, {1.7, 0.7, 0.7});
  add_box(soup, {1.0, 0.2, 0.2}, {1.8, 0.8, 0.8});
  turn_inside_out(soup, bodies);
  check_run(*run_soup(soup, 0.06), 2, 4);
}

TEST_CASE("bars that cross at an acute angle are one body without handles, however they lie") {
  // Ends of the outside as thin as can be, which a lattice breaks; each with a turn at which it did.
  struct Crossing {
    double degrees;
    std::array<double, 4> turn; ///< a quaternion, real part first
  };
  for (const Crossing& crossing : {Crossing{20, {-0.406300, -0.395726, 0.230740, -0.790620}},
                                   Crossing{23, {0.248045, -0.888253, -0.384920, 0.036301}},
                                   Crossing{29, {0.124498, 0.844536, 0.365187, 0.371346}}}) {
    TriangleSoup soup;
    add_box(soup, {-1, -0.12, -0.12}, {1, 0.12, 0.12});
    add_box(soup, {-1, -0.12, -0.1}, {1, 0.12, 0.15});
    const double angle = crossing.degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    const auto [w, x, y, z] = crossing.turn;
    const Vec3 v{x, y, z};
    for (std::size_t i = 0; i < soup.points.size(); ++i) {
      Vec3& p = soup.points[i];
      if (i >= soup.points.size() / 2) p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
      const Vec3 u = cross(v, p) + w * p;
      p = p + 2.0 * cross(v, u);
    }
    CAPTURE(crossing.degrees);
    check_run(*run_soup(soup, 0.0362), 1, 2);
  }
}

TEST_CASE("a pit where three balls cross is closed by Ω: its bottom need not be near") {
  TriangleSoup soup;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * std::numbers::pi * k / 3;
    add_sphere(soup, {0.9 * std::cos(angle), 0.9 * std::sin(angle), 0}, 0.84, 16);
  }
  auto run = std::make_unique<CompleteRun>(std::move(soup), 0.07);
  run->parameters.input = "soup";
  run->parameters.effort = 0;
  run->parameters.cover = 1.2;
  run->run();
  check_run(*run, 1, 2);
}

TEST_CASE("the bottom of a groove need not be near where another part closes what is above it") {
  const auto judge_bottom = [](double plug_from) {
    TriangleSoup soup;
    add_grooved_block(soup);
    add_box(soup, {-0.2, -0.2, plug_from}, {0.2, 2.2, 1.2});
    CompleteRun run(soup, 0.06);
    REQUIRE(run.prepare());
    const ClosestPoint on = run.scene->volume->index().closest({0.02, 1, 0.3 + 0.02 * 0.7 / 0.4});
    return InputWalls(*run.scene->volume).judge(on.triangle, on.point, normalized(Vec3{-0.7, 0, 0.4}));
  };
  // The pocket below the plug has room for a ball of 0.04, less than δ'; further up for one of 0.09.
  CHECK(judge_bottom(0.42).kind == Wall::of_closed_gap);
  CHECK(judge_bottom(0.42).outward == 1);
  CHECK(judge_bottom(0.7).kind == Wall::outer);

  TriangleSoup plugged;
  add_grooved_block(plugged);
  add_box(plugged, {-0.2, -0.2, 0.42}, {0.2, 2.2, 1.2});
  check_run(*run_soup(plugged, 0.06), 1, 2);
}

TEST_CASE("what offsets of the outside have in common is told by a count that two lattices agree on") {
  TriangleSoup soup = overlapping_boxes();
  const auto run = run_soup(soup, 0.1);
  REQUIRE(run->scene);
  const ExpectedTopology& expected = run->scene->expected;
  CHECK(expected.joined);
  CHECK(expected.required);
  CHECK(expected.euler_characteristic == 2);
  CHECK(expected.components == 1u);
  CHECK(expected.reach > 0.5 * run->scene->thresholds.boundary);
  CHECK(expected.reach < run->scene->thresholds.boundary);
}

TEST_CASE("boxes that touch at an edge, a vertex or in parts of faces and edges are joined there") {
  for (const Vec3 corner :
       {Vec3{1, 1, 0}, Vec3{1, 1, 1}, Vec3{1, 0.4, 0.3}, Vec3{1, 1, 0.4}, Vec3{1, 0, 0}}) {
    TriangleSoup soup;
    add_box(soup, {0, 0, 0}, {1, 1, 1});
    add_box(soup, corner, corner + Vec3{1, 1, 1});
    const auto run = run_soup(soup, 0.1);
    CAPTURE(corner.x + 10 * corner.y + 100 * corner.z);
    check_run(*run, 1, 2);
  }
}

TEST_CASE("voxels with contacts at edges and corners are joined there, and keep their holes and cavities") {
  for (const unsigned seed : {1u, 2u}) {
    const Voxels voxels(3, seed, 0.45);
    const auto run = run_soup(voxels.surface(), 0.15);
    CAPTURE(seed);
    check_run(*run, voxels.components(true) + voxels.components(false) - 1,
              2 * voxels.euler_characteristic());
  }
}

TEST_CASE("plates far thinner than the tolerance that go through a body are whole, without holes") {
  SUBCASE("out of a box") {
    TriangleSoup soup;
    add_box(soup, {0, 0, 0}, {1, 1, 1});
    add_box(soup, {0.9, 0.2, 0.499}, {2.5, 0.8, 0.501});
    check_run(*run_soup(soup, 0.05), 1, 2);
  }
  SUBCASE("through a ball: where parts are joined there are no samples to tell what is inside") {
    TriangleSoup soup;
    isoscope::testing::add_sphere(soup, {0, 0, 0}, 1, 12);
    add_box(soup, {-1.8, -0.003, -0.5}, {1.8, 0.003, 0.5});
    check_run(*run_soup(soup, 0.072), 1, 2);
  }
  SUBCASE("crossing each other around an axle") {
    TriangleSoup soup;
    isoscope::testing::add_sphere(soup, {0, 0, 0}, 0.6, 12);
    add_box(soup, {-0.01, -1.2, -0.15}, {0.01, 1.2, 0.15});
    add_box(soup, {-1.2, -0.01, -0.15}, {1.2, 0.01, 0.15});
    check_run(*run_soup(soup, 0.07), 1, 2);
  }
}
