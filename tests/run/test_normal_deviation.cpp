// Normal deviation with known answers: shares of the area, signs where the input has a side, none where not.
#include "run/normal_deviation.h"

#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

constexpr double deviation_delta = 0.15;

NormalDeviation measured(const TriangleSoup& mesh, const TriangleSoup& input) {
  auto volume = ToleranceVolume::build(std::make_shared<const ClosestPointIndex>(input), analyse_input(input),
                                       {deviation_delta, 0.95}, RunControl());
  REQUIRE(volume.ok());
  return measure_normal_deviation({mesh.points, mesh.triangles}, *volume);
}

TriangleSoup unit_cube() {
  TriangleSoup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  return soup;
}

double sum(const NormalDeviation& n) {
  return std::accumulate(n.histogram.begin(), n.histogram.end(), 0.0);
}

} // namespace

TEST_CASE("A surface does not deviate from itself, nor from itself turned around") {
  TriangleSoup turned = unit_cube();
  for (auto& t : turned.triangles) std::swap(t[0], t[1]);
  for (const TriangleSoup& mesh : {unit_cube(), turned}) {
    const NormalDeviation n = measured(mesh, unit_cube());
    CHECK(n.oriented);
    CHECK(n.points > 10000);
    CHECK(n.histogram[0] == doctest::Approx(1));
    CHECK(sum(n) == doctest::Approx(1));
    CHECK(n.mean == doctest::Approx(0));
    CHECK(n.percentile_99 < 1e-6);
    CHECK(n.above_30 == 0);
  }
}

TEST_CASE("A roof of 12° deviates by 12° on its share of the area") {
  const double degrees = 12, slope = std::tan(degrees * std::numbers::pi / 180);
  // Facets 2 and 3 are the face z = 1 with the corners 4, 5, 7, 6.
  TriangleSoup roof = unit_cube();
  roof.triangles.erase(roof.triangles.begin() + 2, roof.triangles.begin() + 4);
  roof.points.push_back({0.5, 0.5, 1 + 0.5 * slope});
  for (const auto& [a, b] : {std::pair{4u, 5u}, {5u, 7u}, {7u, 6u}, {6u, 4u}})
    roof.triangles.push_back({a, b, 8});
  const NormalDeviation n = measured(roof, unit_cube());
  const double top = std::sqrt(1 + slope * slope), share = top / (top + 5);
  CHECK(n.oriented);
  CHECK(n.histogram[2] == doctest::Approx(share));
  CHECK(n.histogram[0] == doctest::Approx(1 - share));
  CHECK(n.mean == doctest::Approx(share * degrees));
  CHECK(n.percentile_90 == doctest::Approx(degrees));
  CHECK(n.above_30 == 0);
}

TEST_CASE("A facet that lies upside down counts with 180°") {
  TriangleSoup doubled = unit_cube();
  const auto t = doubled.triangles[0];
  doubled.triangles.push_back({t[0], t[2], t[1]});
  const NormalDeviation n = measured(doubled, unit_cube());
  CHECK(n.histogram.back() == doctest::Approx(0.5 / 6.5));
  CHECK(n.above_30 == doctest::Approx(0.5 / 6.5));
  CHECK(n.above_90 == doctest::Approx(0.5 / 6.5));
  CHECK(n.percentile_90 < 1e-6);
  CHECK(n.percentile_99 == doctest::Approx(180));
}

TEST_CASE("An input without consistent orientation gives angles without a sign") {
  TriangleSoup mixed = unit_cube();
  std::swap(mixed.triangles[5][0], mixed.triangles[5][1]);
  TriangleSoup doubled = unit_cube();
  const auto t = doubled.triangles[0];
  doubled.triangles.push_back({t[0], t[2], t[1]});
  const NormalDeviation n = measured(doubled, mixed);
  CHECK(!n.oriented);
  CHECK(n.histogram[0] == doctest::Approx(1));
  CHECK(n.above_90 == 0);
}

TEST_CASE("A cavity may be given either way around") {
  for (const bool inward : {false, true}) {
    TriangleSoup input, mesh;
    add_box(input, {0, 0, 0}, {4, 4, 4});
    add_box(input, {1, 1, 1}, {3, 3, 3});
    mesh = input;
    const auto turn_cavity = [](TriangleSoup& soup) {
      for (std::size_t f = 12; f < 24; ++f) std::swap(soup.triangles[f][0], soup.triangles[f][1]);
    };
    if (inward) turn_cavity(input);
    turn_cavity(mesh);
    const NormalDeviation n = measured(mesh, input);
    CHECK(n.oriented);
    CHECK(n.histogram[0] == doctest::Approx(1));
  }
}

TEST_CASE("Nothing to measure is said") {
  CHECK(measured({}, unit_cube()).points == 0);
}

TEST_CASE("An empty mesh has no normals to measure") {
  CHECK(measured({}, unit_cube()).points == 0);
}
