// Runs on soups whose triangles are not joined: their gaps are far narrower than δ, their parts may be
// thinner.
#include "run/complete_run.h"
#include "run/cube_with_bar.h"
#include "run/input_walls.h"
#include "run/voxel_soup.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace isoscope;
using namespace isoscope::test;
using namespace isoscope::testing;

namespace {

constexpr double delta = 0.06;

/// Each triangle with corners of its own, which are moved by less than `gap`.
TriangleSoup cracked(const TriangleSoup& soup, double gap) {
  TriangleSoup out;
  Random random(3);
  for (const auto& t : soup.triangles) {
    const auto first = static_cast<std::uint32_t>(out.points.size());
    for (const std::uint32_t v : t)
      out.points.push_back(soup.points[v] + Vec3{random.between(-gap, gap), random.between(-gap, gap),
                                                 random.between(-gap, gap)});
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

/// A box whose faces are pieces of their own, each moved by less than `gap`.
void add_box_of_pieces(TriangleSoup& soup, Vec3 lo, Vec3 hi, double gap, Random& random) {
  TriangleSoup box;
  add_box(box, lo, hi);
  Vec3 off;
  for (std::size_t t = 0; t < box.triangles.size(); ++t) {
    if (t % 2 == 0) off = {random.between(-gap, gap), random.between(-gap, gap), random.between(-gap, gap)};
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const Vec3 p : box.triangle(t)) soup.points.push_back(p + off);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
}

/// Two unit cubes, joined by a plate of this thickness.
TriangleSoup dumbbell(double thickness) {
  TriangleSoup soup = cube_with_bar(0.2, 0.8, 0.5 - thickness / 2, 0.5 + thickness / 2, 0.5);
  soup.triangles.resize(soup.triangles.size() - 2);
  const std::size_t half = soup.triangles.size();
  const auto points = static_cast<std::uint32_t>(soup.points.size());
  for (std::uint32_t v = 0; v < points; ++v) {
    const Vec3 p = soup.points[v];
    soup.points.push_back({3 - p.x, p.y, p.z});
  }
  for (std::size_t t = 0; t < half; ++t) {
    const auto [a, b, c] = soup.triangles[t];
    soup.triangles.push_back({points + a, points + c, points + b});
  }
  return soup;
}

void check_certified(CompleteRun& run, long euler_characteristic) {
  run.parameters.effort = 0;
  REQUIRE(run.run());
  const Certificate& c = run.result->certificate;
  CHECK(run.result->exit_status() == 0);
  CHECK(c.components == 1);
  CHECK(c.euler_characteristic == euler_characteristic);
  CHECK(c.covers);
  CHECK(c.input_distance.upper <= 3 * delta * 1.001);
}

} // namespace

TEST_CASE(
    "Fins and spikes of a soup with cracks or without a facet are kept like those of a closed surface") {
  for (const TriangleSoup& closed :
       {cube_with_bar(0.2, 0.8, 0.49, 0.51, 1), cube_with_bar(0.48, 0.52, 0.48, 0.52, 1)}) {
    CompleteRun soup(cracked(closed, 0.004), delta);
    check_certified(soup, 2);
    CHECK(soup.scene->volume->sides().by_solid_angles());
    CHECK(soup.scene->volume->held() > 0);

    TriangleSoup less = closed;
    less.triangles.pop_back();
    CompleteRun open(less, delta);
    check_certified(open, 2);
    CHECK(open.scene->volume->sides().by_solid_angles());
  }
}

TEST_CASE("A rod is kept also on a body with holes as wide as Ω closes them") {
  // One face in five of a cube of 12³ cubes is missing, whose winding is then 0.8 inside.
  constexpr double side = 0.07;
  TriangleSoup soup =
      voxel_surface({20, 12, 12}, [](int x, int y, int z) { return x < 12 || (y == 6 && z == 6); });
  std::vector<std::array<std::uint32_t, 3>> kept;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto& v = soup.triangles[t];
    const bool of_body = std::all_of(v.begin(), v.end(), [&](auto i) { return soup.points[i].x <= 12; });
    if (!of_body || t / 2 % 5 != 0) kept.push_back(v);
  }
  soup.triangles = kept;
  for (Vec3& p : soup.points) p = side * p;
  CompleteRun run(soup, delta);
  check_certified(run, 2);
  CHECK(run.scene->volume->sides().by_solid_angles());
  CHECK(run.scene->volume->held() > 0);
}

TEST_CASE("What is thinner than Ω between two regions of a soup parts no rooms") {
  CompleteRun oriented(cracked(dumbbell(0.06), 0.004), delta);
  check_certified(oriented, 2);

  // Rays tell how triangles that run this way and that have to turn.
  TriangleSoup mixed = cracked(dumbbell(0.06), 0.004);
  Random random(9);
  for (auto& t : mixed.triangles)
    if (random.unit() < 0.5) std::swap(t[1], t[2]);
  CompleteRun unoriented(mixed, delta);
  check_certified(unoriented, 2);
  CHECK(unoriented.scene->volume->sides().by_solid_angles());

  // Where the user wants parity, walls tell what they part.
  CompleteRun coloured(mixed, delta);
  coloured.parameters.sides = SidesMode::parity;
  REQUIRE(coloured.prepare());
  CHECK_FALSE(coloured.scene->volume->sides().by_solid_angles());
  CHECK_FALSE(coloured.scene->volume->has_rooms());
  const auto& regions = coloured.scene->regions;
  CHECK(std::count_if(regions.begin(), regions.end(), [](const Region& r) { return r.label < 0; }) == 2);
}

TEST_CASE("A spike of two parts that overlap is kept, though a wall of each lies within the other") {
  TriangleSoup soup = cube_with_bar(0.47, 0.53, 0.47, 0.53, 1);
  const TriangleSoup once = soup;
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (const Vec3 p : once.points) soup.points.push_back(p + Vec3{0.05, 0.02, 0.03});
  for (const auto& t : once.triangles) soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  CompleteRun run(soup, delta);
  check_certified(run, 2);
  CHECK(run.scene->volume->held() > 0);
}

TEST_CASE("Cracks do not make one part of bodies that cross, and Ω closes gaps between these") {
  // Two cubes with a gap of 0.6 δ between them, and a bar through both.
  TriangleSoup soup;
  Random random(5);
  const double gap = 0.6 * delta, crack = 0.05 * delta;
  add_box_of_pieces(soup, {0, 0, 0}, {1, 1, 1}, crack, random);
  add_box_of_pieces(soup, {1 + gap, 0, 0}, {2 + gap, 1, 1}, crack, random);
  add_box_of_pieces(soup, {0.5, 0.3, 0.7}, {1.5, 0.6, 1.4}, crack, random);
  CompleteRun run(soup, delta);
  REQUIRE(run.prepare());
  const ToleranceVolume& volume = *run.scene->volume;
  REQUIRE(volume.sides().by_solid_angles());
  const InputWalls walls(volume);
  const auto judge_at = [&](Vec3 p, Vec3 normal) {
    const ClosestPoint on = volume.index().closest(p);
    return walls.judge(on.triangle, on.point, normal);
  };
  CHECK(judge_at({1, 0.4, 0.2}, {1, 0, 0}).kind == Wall::of_closed_gap);
  CHECK(judge_at({0, 0.4, 0.2}, {-1, 0, 0}).kind == Wall::outer);
  CHECK(judge_at({0, 0.4, 0.2}, {-1, 0, 0}).outward == 1);
  CHECK(judge_at({0.9, 0.45, 1}, {0, 0, 1}).kind == Wall::inner);
  // Beside a crack the rest of the same body is no other part.
  const auto near_another = [&](Vec3 p) {
    const ClosestPoint on = volume.index().closest(p);
    return walls.near_another_part(on.triangle, {on.point, on.point, on.point});
  };
  CHECK_FALSE(near_another({0, 0.01, 0.5}));
  CHECK(near_another({1, 0.4, 0.2}));

  CompleteRun whole(soup, delta);
  check_certified(whole, 2);
  for (const auto& l : whole.result->certificate.failures) MESSAGE(l);
}
