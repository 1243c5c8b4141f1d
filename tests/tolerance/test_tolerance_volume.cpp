// Regions, labels, Euler characteristics and messages on hand-made surfaces whose answers are known.
#include "tolerance/boundary_topology.h"
#include "tolerance/shapes.h"
#include "tolerance/tolerance_volume.h"

#include <doctest/doctest.h>

#include <vector>

#include <algorithm>
#include <array>
#include <string>

using namespace isoscope;
using isoscope::testing::Random;

namespace {

Result<ToleranceVolume> build(const TriangleSoup& soup, double delta, double ratio = 0.95) {
  const auto index = std::make_shared<const ClosestPointIndex>(soup);
  return ToleranceVolume::build(index, analyse_input(soup), {delta, ratio}, RunControl());
}

long euler(const ToleranceVolume& v, int label) {
  long sum = 0;
  for (const BoundaryComponent& c : v.boundary_components())
    if (c.label == label) sum += c.euler_characteristic;
  return sum;
}

std::size_t count(const ToleranceVolume& v, int label) {
  std::size_t n = 0;
  for (const Region& r : v.regions()) n += r.label == label ? 1u : 0u;
  return n;
}

/// Two square plates of thickness t, a gap g between them.
TriangleSoup plates(double thickness, double gap) {
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {1, 1, thickness});
  testing::add_box(soup, {0, 0, thickness + gap}, {1, 1, 2 * thickness + gap});
  return soup;
}

/// A plate of this thickness with a hole through its narrow middle: a frame of four bars.
TriangleSoup frame(double thickness) {
  const std::array<double, 4> x{0, thickness, 0.6, 1}, y{0, 0.45, 0.83, 1.6};
  const std::array<double, 2> z{0, 1};
  TriangleSoup soup;
  const auto quad = [&](Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const auto base = static_cast<std::uint32_t>(soup.points.size());
    soup.points.insert(soup.points.end(), {a, b, c, d});
    soup.triangles.push_back({base, base + 1, base + 2});
    soup.triangles.push_back({base, base + 2, base + 3});
  };
  const auto solid = [](int i, int j) { return i >= 0 && i < 3 && j >= 0 && j < 3 && !(i == 1 && j == 1); };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (!solid(i, j)) continue;
      const double x0 = x[std::size_t(i)], x1 = x[std::size_t(i) + 1], y0 = y[std::size_t(j)],
                   y1 = y[std::size_t(j) + 1];
      quad({x0, y0, z[0]}, {x0, y1, z[0]}, {x1, y1, z[0]}, {x1, y0, z[0]});
      quad({x0, y0, z[1]}, {x1, y0, z[1]}, {x1, y1, z[1]}, {x0, y1, z[1]});
      if (!solid(i - 1, j)) quad({x0, y0, z[0]}, {x0, y0, z[1]}, {x0, y1, z[1]}, {x0, y1, z[0]});
      if (!solid(i + 1, j)) quad({x1, y0, z[0]}, {x1, y1, z[0]}, {x1, y1, z[1]}, {x1, y0, z[1]});
      if (!solid(i, j - 1)) quad({x0, y0, z[0]}, {x1, y0, z[0]}, {x1, y0, z[1]}, {x0, y0, z[1]});
      if (!solid(i, j + 1)) quad({x0, y1, z[0]}, {x0, y1, z[1]}, {x1, y1, z[1]}, {x1, y1, z[0]});
    }
  return soup;
}

/// Nothing that cannot be is said of the boundaries of Ω.
void check_told(const ToleranceVolume& v) {
  CAPTURE(v.thickening_note());
  if (!v.topology_told()) {
    CHECK(v.thickening_note().find("could not be told") != std::string::npos);
    CHECK(v.thickening_note().find("Euler") == std::string::npos);
    return;
  }
  for (const BoundaryComponent& c : v.boundary_components()) {
    CHECK(c.euler_characteristic % 2 == 0);
    CHECK(c.euler_characteristic <= 2);
  }
}

void check_thin_walls(const std::vector<double>& widths) {
  const double delta = 0.064;
  int told = 0, tried = 0;
  for (const double width : widths) {
    CAPTURE(width);
    TriangleSoup slab;
    testing::add_box(slab, {0, 0, 0}, {width * delta, 1, 1.6});
    auto wall = build(slab, delta), ring = build(frame(width * delta), delta),
         gap = build(plates(0.4, width * delta), delta);
    REQUIRE((wall.ok() && ring.ok() && gap.ok()));
    for (const auto* v : {&*wall, &*ring, &*gap}) {
      check_told(*v);
      // It is a thickening whatever the lattice sees.
      CHECK(v->thickening() == v->topology_told());
      told += v->topology_told() ? 1 : 0;
      ++tried;
    }
    if (ring->topology_told()) CHECK(euler(*ring, -1) == 0);
  }
  CHECK(2 * told > tried);
}

} // namespace

TEST_CASE("Each boundary is one piece, also where its cells are counted in several blocks") {
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {1, 1, 1});
  const auto v = build(soup, 0.012);
  REQUIRE(v.ok());
  for (const unsigned halvings : {0u, 1u}) {
    CAPTURE(halvings);
    const auto counts = count_boundaries(*v, {halvings, true}, RunControl());
    REQUIRE(counts.ok());
    REQUIRE(counts->size() == 2);
    for (const BoundaryCount& c : *counts) {
      CHECK(c.pieces == 1);
      CHECK(c.euler_characteristic == 2);
    }
  }
}

TEST_CASE("walls and gaps of little more than twice the tolerance are counted right, or not at all") {
  check_thin_walls({2.3, 2.66});
}

// Below 2.2 δ the lattice may break a ring at one place alone, which leaves a piece that can be.
TEST_CASE("walls and gaps of any such width are counted right, or not at all" * doctest::test_suite("soak")) {
  check_thin_walls({2.2, 2.3, 2.45, 2.6, 2.66, 2.8});
}

TEST_CASE("a tolerance that takes too much memory is refused at once, with one that does not") {
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {1, 1, 1});
  const auto index = std::make_shared<const ClosestPointIndex>(soup);
  const auto build_within = [&](double delta, double bytes, double& progress) {
    RunControl control;
    control.on_progress([&](std::string_view part, double fraction) {
      if (part == "regions") progress = std::max(progress, fraction);
    });
    return ToleranceVolume::build(index, analyse_input(soup), {delta, 0.95, bytes}, control);
  };
  for (const double bytes : {3e7, 1e10}) {
    CAPTURE(bytes);
    double progress = 0;
    const auto refused = build_within(1e-4, bytes, progress);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.error().code == ErrorCode::unsupported);
    CHECK(progress < 0.65); // of the levels, each of which takes four times as long as the one before
    const std::string& remedy = refused.error().remedy;
    REQUIRE(remedy.find("Choose a tolerance of at least ") == 0);
    if (bytes > 1e9) continue;
    const double least = std::stod(remedy.substr(remedy.find("least ") + 6));
    CHECK(least < 0.05);
    CHECK(build_within(least, bytes, progress).ok());
  }
}

TEST_CASE("a sphere has an outside and an inside, both spheres") {
  TriangleSoup soup;
  testing::add_sphere(soup, {1, 2, 3}, 1, 32);
  for (const double ratio : {0.95, 1.0}) {
    auto v = build(soup, 0.05, ratio);
    REQUIRE(v.ok());
    REQUIRE(v->regions().size() == 2);
    CHECK(v->regions()[0].unbounded);
    CHECK(v->regions()[0].label == +1);
    CHECK(v->regions()[1].label == -1);
    CHECK(v->regions()[1].depth > 0.9);
    CHECK(distance(v->regions()[1].deepest, {1, 2, 3}) < 0.1);
    CHECK(v->regions()[1].volume > 2.5);
    CHECK(v->regions()[1].volume < 4.19);
    REQUIRE(v->boundary_components().size() == 2);
    CHECK(v->boundary_components()[0].euler_characteristic == 2);
    CHECK(v->boundary_components()[1].euler_characteristic == 2);
    CHECK(v->thickening());
    CHECK(v->thickening_note().empty());
    CHECK(v->label_at({1, 2, 3}) == -1);
    CHECK(v->label_at({1, 2, 4.2}) == +1);
    CHECK(v->label_at({100, 0, 0}) == +1);
    CHECK(v->label_at({1, 2, 4}) == 0);
  }
}

TEST_CASE("every point beyond the reject distance has the label of its side") {
  TriangleSoup soup;
  testing::add_torus(soup, {0, 0, 0}, 1, 0.4, 24);
  auto v = build(soup, 0.03);
  REQUIRE(v.ok());
  CHECK(euler(*v, +1) == 0);
  CHECK(euler(*v, -1) == 0);
  Random random(4);
  const ToleranceThresholds t = v->thresholds();
  CHECK(t.boundary < t.reject);
  CHECK(t.reject < t.delta);
  for (int i = 0; i < 5000; ++i) {
    const std::size_t face = random.below(soup.triangles.size());
    const Vec3 p = soup.triangle(face)[0] + random.between(0.9, 1.3) * t.delta * random.direction();
    if (v->index().distance(p) <= t.reject) continue;
    CHECK(v->label_at(p) == (v->index().inside_by_parity(p) ? -1 : +1));
  }
}

TEST_CASE("nested spheres alternate, and each component of the volume has its own boundary") {
  TriangleSoup soup;
  for (const double r : {1.0, 0.7, 0.4}) testing::add_sphere(soup, {0, 0, 0}, r, 24);
  auto v = build(soup, 0.04);
  REQUIRE(v.ok());
  CHECK(v->volume_component_count() == 3);
  CHECK(count(*v, +1) == 2);
  CHECK(count(*v, -1) == 2);
  CHECK(v->boundary_components().size() == 6);
  for (const BoundaryComponent& c : v->boundary_components()) CHECK(c.euler_characteristic == 2);
  CHECK(v->thickening());
  CHECK(v->label_at({0, 0, 1.2}) == +1);
  CHECK(v->label_at({0, 0, 0.85}) == -1);
  CHECK(v->label_at({0, 0, 0.55}) == +1);
  CHECK(v->label_at({0, 0, 0}) == -1);
}

TEST_CASE("spheres side by side share the outside") {
  TriangleSoup soup;
  testing::add_sphere(soup, {0, 0, 0}, 1, 16);
  testing::add_sphere(soup, {3, 0, 0}, 1, 16);
  auto v = build(soup, 0.1);
  REQUIRE(v.ok());
  CHECK(v->regions().size() == 3);
  CHECK(v->volume_component_count() == 2);
  CHECK(v->thickening());
}

TEST_CASE("a gap closes when it is narrower than twice the boundary distance, and opens when wider") {
  const double delta = 0.04, boundary = 0.95 * delta;
  auto closed = build(plates(0.3, 1.9 * boundary), delta);
  REQUIRE(closed.ok());
  CHECK(closed->volume_component_count() == 1);
  CHECK_FALSE(closed->thickening());
  CHECK(closed->thickening_note().find("no thickening") != std::string::npos);
  CHECK(build(plates(0.3, 4 * boundary), delta)->thickening());
  auto open = build(plates(0.3, 2.2 * boundary), delta);
  REQUIRE(open.ok());
  CHECK(open->volume_component_count() == 2);
  const Vec3 middle{0.5, 0.5, 0.3 + 1.1 * boundary};
  CHECK(open->label_at(middle) == +1);
  CHECK(closed->label_at({0.5, 0.5, 0.3 + 0.95 * boundary}) == 0);
}

TEST_CASE("a gap barely wide enough for the reject distance is joined to the outside") {
  const double delta = 0.04, reject = 0.975 * delta;
  auto v = build(plates(0.3, 2.02 * reject), delta);
  REQUIRE(v.ok());
  CHECK(count(*v, +1) == 1);
  const Vec3 middle{0.5, 0.5, 0.3 + 1.01 * reject};
  REQUIRE(v->index().distance(middle) > reject);
  CHECK(v->label_at(middle) == +1);
  CHECK(v->regions().size() == 3);
}

TEST_CASE("open surfaces have a rim and sides by orientation, or are named where they are not wanted") {
  TriangleSoup soup;
  testing::add_sphere(soup, {0, 0, 0}, 1, 24);
  std::erase_if(soup.triangles, [&](const auto& t) {
    return soup.points[t[0]].z > 0.8 || soup.points[t[1]].z > 0.8 || soup.points[t[2]].z > 0.8;
  });
  auto v = build(soup, 0.05);
  REQUIRE(v.ok());
  REQUIRE(v->open_sides() != nullptr);
  CHECK(v->thickening());
  const Rim& rim = v->open_sides()->rim();
  REQUIRE(rim.loops().size() == 1);
  const RimLoop& loop = rim.loops().front();
  CHECK(loop.flatness < 0.01);
  CHECK(std::abs(loop.normal.z) > 0.99);
  double lowest = 1;
  for (const RimPiece& piece : rim.pieces()) {
    CHECK(piece.open);
    CHECK(piece.conormal.z > 0);
    lowest = std::min(lowest, piece.a.z);
  }
  CHECK(lowest == doctest::Approx(loop.center.z));
  CHECK(v->label_at({0, 0, -1.07}) == +1);
  CHECK(v->label_at({0, 0, -0.93}) == -1);
  const double radius = std::sqrt(1 - lowest * lowest);
  CHECK(v->label_at({radius, 0, lowest + 0.06}) == 0);

  const auto index = std::make_shared<const ClosestPointIndex>(soup);
  ToleranceVolume::Options closed{0.05, 0.95};
  closed.open_surfaces = false;
  const auto refused = ToleranceVolume::build(index, analyse_input(soup), closed, RunControl());
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().code == ErrorCode::open_surface);
  CHECK(refused.error().message.find("open surface near") != std::string::npos);
  CHECK_FALSE(refused.error().remedy.empty());
}

TEST_CASE("a soup with gaps closes under a large tolerance and is open under a small one") {
  TriangleSoup sphere;
  testing::add_sphere(sphere, {0, 0, 0}, 1, 16);
  const TriangleSoup soup = testing::exploded(sphere, 0.7);
  CHECK_FALSE(analyse_input(soup).closed_manifold);
  auto v = build(soup, 0.08);
  REQUIRE(v.ok());
  CHECK(v->regions().size() == 2);
  CHECK(v->label_at({0, 0, 0}) == -1);
  CHECK(v->thickening());
  CHECK(euler(*v, -1) == 2);
  const auto open = build(soup, 0.015);
  REQUIRE_FALSE(open.ok());
  CHECK(open.error().message.find("open surface") != std::string::npos);
}

TEST_CASE("an inner wall makes two rooms of a soup") {
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {2, 1, 1});
  const auto base = static_cast<std::uint32_t>(soup.points.size());
  for (const Vec3 p : {Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{1, 1, 1}, Vec3{1, 0, 1}}) soup.points.push_back(p);
  soup.triangles.push_back({base, base + 1, base + 2});
  soup.triangles.push_back({base, base + 2, base + 3});
  auto v = build(soup, 0.05);
  REQUIRE(v.ok());
  CHECK(v->has_rooms());
  CHECK(v->sides().rule() == SideRule::rooms);
  CHECK(v->regions().size() == 3);
  CHECK(v->label_at({-1, 0.5, 0.5}) == +1);
  const int left = v->label_at({0.5, 0.5, 0.5}), right = v->label_at({1.5, 0.5, 0.5});
  CHECK(std::min(left, right) == -2);
  CHECK(std::max(left, right) == -1);
  CHECK(v->label_at({1, 0.5, 0.5}) == 0);
  for (const BoundaryComponent& c : v->boundary_components()) CHECK(c.euler_characteristic == 2);

  // A wall that stands out is no wall between rooms.
  const auto fin = static_cast<std::uint32_t>(soup.points.size());
  for (const Vec3 p : {Vec3{1, 0, 1}, Vec3{1, 1, 1}, Vec3{1, 1, 1.4}, Vec3{1, 0, 1.4}})
    soup.points.push_back(p);
  soup.triangles.push_back({fin, fin + 1, fin + 2});
  soup.triangles.push_back({fin, fin + 2, fin + 3});
  const auto refused = build(soup, 0.05);
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().code == ErrorCode::joined_sheets);
  CHECK(refused.error().message.find("near (1, ") != std::string::npos);
}

TEST_CASE("bad options and cancellation come back as errors") {
  TriangleSoup soup;
  testing::add_sphere(soup, {0, 0, 0}, 1, 12);
  CHECK(build(soup, 0).error().code == ErrorCode::usage);
  CHECK(build(soup, 0.1, 1.5).error().code == ErrorCode::usage);
  RunControl control;
  control.cancel();
  const auto v = ToleranceVolume::build(std::make_shared<const ClosestPointIndex>(soup), analyse_input(soup),
                                        {0.05, 0.95}, control);
  REQUIRE_FALSE(v.ok());
  CHECK(v.error().code == ErrorCode::cancelled);
}

TEST_CASE("connectivity is found after merging equal points") {
  TriangleSoup sphere, torus;
  testing::add_sphere(sphere, {0, 0, 0}, 1, 12);
  testing::add_torus(torus, {0, 0, 0}, 1, 0.4, 12);
  CHECK(analyse_input(sphere).euler_characteristic == 2);
  CHECK(analyse_input(torus).euler_characteristic == 0);
  TriangleSoup apart;
  for (std::uint32_t i = 0; i < torus.triangles.size(); ++i) {
    for (const Vec3 p : torus.triangle(i)) apart.points.push_back(p);
    apart.triangles.push_back({3 * i, 3 * i + 2, 3 * i + 1});
  }
  CHECK(analyse_input(apart).euler_characteristic == 0);
  CHECK(analyse_input(apart).self_intersection_free);
  CHECK(analyse_input(sphere).self_intersection_free);
  CHECK(analyse_input(sphere).components == 1);
  CHECK_FALSE(analyse_input(sphere).border);

  TriangleSoup crossing = sphere;
  testing::add_sphere(crossing, {1, 0.1, 0.2}, 1, 12);
  CHECK(analyse_input(crossing).closed_manifold);
  CHECK_FALSE(analyse_input(crossing).self_intersection_free);
  CHECK(analyse_input(crossing).components == 2);

  TriangleSoup touching;
  testing::add_box(touching, {0, 0, 0}, {1, 1, 1});
  testing::add_box(touching, {1, 1, 1}, {2, 2, 2});
  CHECK_FALSE(analyse_input(touching).closed_manifold);

  TriangleSoup open = sphere;
  open.triangles.pop_back();
  CHECK_FALSE(analyse_input(open).closed_manifold);
  CHECK(analyse_input(open).border);
}
