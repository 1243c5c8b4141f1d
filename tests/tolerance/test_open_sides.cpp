// Rims, loops and sides of open surfaces whose answers are known.
#include "tolerance/boundary_sampler.h"
#include "tolerance/open_shapes.h"
#include "tolerance/shapes.h"
#include "tolerance/thin_parts.h"
#include "tolerance/tolerance_volume.h"
#include "tolerance/wall_samples.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

using namespace isoscope;
using namespace isoscope::test;

namespace {

Result<ToleranceVolume> build(const TriangleSoup& soup, double delta) {
  const auto index = std::make_shared<const ClosestPointIndex>(soup);
  return ToleranceVolume::build(index, analyse_input(soup), {delta, 0.95}, RunControl());
}

double open_length(const Rim& rim) {
  double length = 0;
  for (const RimPiece& piece : rim.pieces())
    if (piece.open) length += distance(piece.a, piece.b);
  return length;
}

} // namespace

TEST_CASE("Corners of holes are open, slits that Ω closes are not") {
  const auto square = build(square_with_hole(), 0.03);
  REQUIRE(square.ok());
  REQUIRE(square->open_sides() != nullptr);
  const Rim& rim = square->open_sides()->rim();
  REQUIRE(rim.loops().size() == 2);
  CHECK(open_length(rim) == doctest::Approx(4 + 4 * 0.4));
  for (const RimLoop& loop : rim.loops()) {
    CHECK(loop.flatness < 1e-9);
    CHECK(distance(loop.center, {0.5, 0.5, 0}) < 1e-9);
    CHECK(std::abs(loop.normal.z) == doctest::Approx(1));
  }
  const auto slit = build(slit_square(), 0.03);
  REQUIRE(slit.ok());
  REQUIRE(slit->open_sides() != nullptr);
  CHECK(slit->open_sides()->rim().loops().size() == 1);
  CHECK(open_length(slit->open_sides()->rim()) == doctest::Approx(4));
}

TEST_CASE("Holes with notches that Ω closes are loops of their own, however near their mouths are") {
  // Two holes with a strip of one cell between them, and a notch of one cell on both sides of it.
  const auto volume = build(grid_sheet(20,
                                       [](double x, double y) {
                                         const bool hole = y > 0.3 && y < 0.6 && x > 0.2 && x < 0.85;
                                         const bool notch = y > 0.6 && y < 0.75 && x > 0.45 && x < 0.6;
                                         const bool strip = x > 0.5 && x < 0.55;
                                         return strip || !(hole || notch);
                                       }),
                            0.04);
  REQUIRE(volume.ok());
  REQUIRE(volume->open_sides() != nullptr);
  const Rim& rim = volume->open_sides()->rim();
  REQUIRE(rim.loops().size() == 3);
  // The sides of the notches are closed.
  CHECK(open_length(rim) < 4 + 4 * 0.3 + 2 * 0.3 + 2 * 0.35);
}

TEST_CASE("A closed part that is thinner than Ω is none of the open ones beside it") {
  TriangleSoup sheet = grid_sheet(10, [](double, double) { return true; });
  TriangleSoup plate;
  testing::add_box(plate, {0.3, 0.3, 0.5}, {0.7, 0.6, 0.52});
  append(sheet, plate);
  const auto volume = build(sheet, 0.05);
  REQUIRE(volume.ok());
  REQUIRE(volume->open_sides() != nullptr);
  CHECK(volume->open_sides()->is_open(TriangleId(0)));
  CHECK_FALSE(
      volume->open_sides()->is_open(TriangleId(static_cast<std::uint32_t>(sheet.triangles.size()) - 1)));
  const auto parts = find_thin_parts(*volume);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].triangles == 12);

  // A triangle whose rim Ω closes is none either.
  const auto first = static_cast<std::uint32_t>(sheet.points.size());
  sheet.points.insert(sheet.points.end(), {{0.5, 0.5, -0.5}, {0.52, 0.5, -0.5}, {0.5, 0.52, -0.5}});
  sheet.triangles.push_back({first, first + 1, first + 2});
  const auto crumbs = build(sheet, 0.05);
  REQUIRE(crumbs.ok());
  CHECK(find_thin_parts(*crumbs).size() == 2);
}

TEST_CASE("Two patches that touch along a seam without sharing points are one surface with one rim") {
  TriangleSoup left = grid_sheet(10, [](double, double) { return true; }), right = left;
  for (Vec3& p : right.points) p.x += 1.0005;
  append(left, right);
  const auto volume = build(left, 0.03);
  REQUIRE(volume.ok());
  REQUIRE(volume->open_sides() != nullptr);
  CHECK(volume->volume_component_count() == 1);
  CHECK(volume->open_sides()->rim().loops().size() == 1);
  CHECK(open_length(volume->open_sides()->rim()) == doctest::Approx(6).epsilon(0.02));
}

TEST_CASE("Triangles without area have no border") {
  const auto volume = build(square_with_needle(), 0.02);
  REQUIRE(volume.ok());
  REQUIRE(volume->open_sides() != nullptr);
  CHECK(volume->open_sides()->rim().loops().size() == 1);
  CHECK(open_length(volume->open_sides()->rim()) == doctest::Approx(4));
}

TEST_CASE("The end of a flap that is folded back is open") {
  const auto volume = build(square_with_flap(0.01), 0.03);
  REQUIRE(volume.ok());
  REQUIRE(volume->open_sides() != nullptr);
  CHECK(volume->open_sides()->rim().loops().size() == 1);
  const auto pieces = volume->open_sides()->rim().pieces();
  CHECK(std::all_of(pieces.begin(), pieces.end(), [](const RimPiece& piece) { return piece.open; }));
}

TEST_CASE("Sides are told by orientation, also where triangles are turned, and by none over the rim") {
  TriangleSoup sheet = grid_sheet(
      12, [](double, double) { return true; }, [](double x, double) { return 0.3 * std::abs(x - 0.5); });
  for (std::size_t t = 0; t < sheet.triangles.size(); t += 3)
    std::swap(sheet.triangles[t][1], sheet.triangles[t][2]);
  const auto volume = build(sheet, 0.03);
  REQUIRE(volume.ok());
  const OpenSides& sides = *volume->open_sides();
  testing::Random random(3);
  int above = 0, below = 0, over = 0;
  const Vec3 up = {0.4, 0.4, 1};
  const auto side_at = [&](Vec3 p) { return sides.side(p, volume->index().closest(p)); };
  const int positive = side_at(up);
  REQUIRE(positive != 0);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random.in_box({{-0.1, -0.1, -0.1}, {1.1, 1.1, 0.3}});
    const bool beside = p.x < 0 || p.x > 1 || p.y < 0 || p.y > 1;
    const double height = p.z - 0.3 * std::abs(p.x - 0.5);
    if (beside) {
      if (p.y >= 0 && p.y <= 1) continue;
      ++over;
      CHECK(side_at(p) == 0);
      continue;
    }
    if (p.x < 0.1 || p.x > 0.9 || std::abs(height) < 1e-3) continue;
    ++(height > 0 ? above : below);
    CHECK(side_at(p) == (height > 0 ? positive : -positive));
  }
  CHECK(above > 100);
  CHECK(below > 100);
  CHECK(over > 100);
}

TEST_CASE("Samples over the rim are apart, the others are on two sides that no path through samples joins") {
  auto volume = build(make_hemisphere(12), 0.06);
  REQUIRE(volume.ok());
  const auto samples = sample_boundary(*volume, 0.03, RunControl());
  REQUIRE(samples.ok());
  CHECK(samples->over_rim.size() > 50);
  CHECK(samples->labels.size() == samples->positions.size());
  CHECK(samples->components.size() == samples->positions.size());
  for (const Vec3 p : samples->over_rim) CHECK(p.z < 0.01);
  for (std::size_t i = 0; i < samples->size(); ++i)
    CHECK(samples->labels[i] == (length(samples->positions[i]) > 1 ? +1 : -1));
}

TEST_CASE("Samples along the wall stand on both sides of the sheet near to all of its rim") {
  auto volume = build(square_with_hole(), 0.04);
  REQUIRE(volume.ok());
  const std::vector<WallSample> samples = wall_samples(*volume);
  for (const RimPiece& piece : volume->open_sides()->rim().pieces()) {
    if (!piece.open) continue;
    for (const int side : {+1, -1})
      CHECK(std::any_of(samples.begin(), samples.end(), [&](const WallSample& s) {
        return s.label == side && distance(s.point, 0.5 * (piece.a + piece.b)) <= 0.04;
      }));
  }
}

TEST_CASE("A turned triangle's samples go with those around them, and so do the places near to it") {
  TriangleSoup sheet = grid_sheet(24, [](double, double) { return true; });
  std::swap(sheet.triangles[24 * 24][1], sheet.triangles[24 * 24][2]);
  TriangleSoup lonely = sheet; // not joined to its neighbours, so that nothing turns it
  const auto t = lonely.triangles[24 * 24];
  for (std::size_t k = 0; k < 3; ++k) {
    lonely.triangles[24 * 24][k] = static_cast<std::uint32_t>(lonely.points.size());
    lonely.points.push_back(lonely.points[t[k]] + Vec3{0, 0, 1e-6});
  }
  auto volume = build(lonely, 0.04);
  REQUIRE(volume.ok());
  REQUIRE(volume->open_sides() != nullptr);
  const auto samples = sample_boundary(*volume, 0.02, RunControl());
  REQUIRE(samples.ok());
  const int up = samples->labels[static_cast<std::size_t>(
      std::max_element(samples->positions.begin(), samples->positions.end(),
                       [](Vec3 a, Vec3 b) { return a.z < b.z; }) -
      samples->positions.begin())];
  for (std::size_t i = 0; i < samples->size(); ++i)
    CHECK(samples->labels[i] == (samples->positions[i].z > 0 ? up : -up));
  const Triangle3 turned{lonely.points[t[0]], lonely.points[t[1]], lonely.points[t[2]]};
  const Vec3 p = centroid(turned) + Vec3{0, 0, 0.05};
  CHECK(volume->open_sides()->side(p, volume->index().closest(p)) == up);
}

TEST_CASE("Sheets that cross are refused with a place on the line where they do") {
  TriangleSoup cross = grid_sheet(8, [](double, double) { return true; });
  TriangleSoup upright = cross;
  for (Vec3& p : upright.points) p = {p.x, 0.55, p.y - 0.45};
  append(cross, upright);
  auto volume = build(cross, 0.05);
  REQUIRE(volume.ok());
  const auto samples = sample_boundary(*volume, 0.025, RunControl());
  REQUIRE_FALSE(samples.ok());
  CAPTURE(samples.error().message);
  CHECK(samples.error().code == ErrorCode::joined_sheets);
  CHECK(samples.error().message.find("sheets cross or branch near (") != std::string::npos);
}

TEST_CASE("Sheets that cross in a ring, so that a part of one would be lost, are refused there") {
  // A cone whose tip goes through a square: both sides of the tip are below it.
  TriangleSoup mask = grid_sheet(24, [](double, double) { return true; });
  for (Vec3& p : mask.points) p = {2 * p.x - 1, 2 * p.y - 1, 0};
  TriangleSoup cone;
  constexpr std::uint32_t around = 48, along = 16;
  for (std::uint32_t j = 1; j <= along; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around, h = 1.0 * j / along;
      cone.points.push_back({0.7 * h * std::cos(angle), 0.7 * h * std::sin(angle), h - 0.4});
    }
  const auto tip = static_cast<std::uint32_t>(cone.points.size());
  cone.points.push_back({0, 0, -0.4});
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t next = (i + 1) % around;
    cone.triangles.push_back({tip, next, i});
    for (std::uint32_t j = 0; j + 1 < along; ++j) {
      const std::uint32_t a = j * around + i, b = j * around + next;
      cone.triangles.push_back({a, b, b + around});
      cone.triangles.push_back({a, b + around, a + around});
    }
  }
  append(mask, cone);
  auto volume = build(mask, 0.03);
  REQUIRE(volume.ok());
  const auto samples = sample_boundary(*volume, 0.015, RunControl());
  REQUIRE_FALSE(samples.ok());
  CAPTURE(samples.error().message);
  CHECK(samples.error().code == ErrorCode::joined_sheets);
  CHECK(samples.error().message.find("sheets cross or branch near (") != std::string::npos);
}

TEST_CASE("A sheet that ends on another one is refused with the place") {
  TriangleSoup fin = make_sphere(3);
  append(fin, grid_sheet(8, [](double, double) { return true; }));
  for (std::size_t i = fin.points.size() - 81; i < fin.points.size(); ++i)
    fin.points[i] = {fin.points[i].x + 0.9, fin.points[i].y - 0.5, 0};
  const auto volume = build(fin, 0.05);
  REQUIRE_FALSE(volume.ok());
  CHECK(volume.error().code == ErrorCode::joined_sheets);
  CHECK(volume.error().message.find("near (") != std::string::npos);
}
