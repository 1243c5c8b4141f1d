// Whole runs on sheets whose rim is hard to reach: tips, teeth, strips, splinters, holes side by side. At the
// least effort, as nothing else may mend there what the cut left.
#include "journal/playback.h"
#include "mesh/zero_set.h"
#include "run/cube_with_bar.h"
#include "run/open_run_checks.h"
#include "tolerance/border_gate.h"
#include "tolerance/open_shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <tuple>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::unique_ptr<CompleteRun> at_least_effort(TriangleSoup soup, double percent, Stage until) {
  RunParameters parameters;
  parameters.tolerance = {percent, true};
  parameters.until = until;
  parameters.effort = 0;
  return finished_run(parameters, std::move(soup));
}

/// A bent square without about one in nine of its triangles, as `seed` has it.
TriangleSoup riddled_square(unsigned seed) {
  TriangleSoup sheet = grid_sheet(
      24, [](double, double) { return true; },
      [](double x, double y) { return 0.3 * x * x - 0.2 * y * y + 0.1 * x * y; });
  std::erase_if(sheet.triangles, [&](const auto&) {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 16 & 0xff) < 28;
  });
  return sheet;
}

} // namespace

TEST_CASE("The border reaches the tip of a wedge, and no crumb of it comes off") {
  for (const double degrees : {60.0, 30.0, 15.0}) {
    CAPTURE(degrees);
    check_certified(*at_least_effort(wedge(degrees), 2, Stage::improve), 1, 1);
  }
}

TEST_CASE("The border follows a tooth that is much narrower than Ω is thick") {
  for (const double width : {0.004, 0.02, 0.05}) {
    CAPTURE(width);
    check_certified(*at_least_effort(square_with_tooth(0.15, width), 3, Stage::improve), 1, 1);
  }
}

TEST_CASE("Of a hollow plate of which little is left inside the lattice tells nothing, and it is kept") {
  // The hollow cube that it stands on has no face x = 0.
  TriangleSoup soup = cube_with_bar(0.2, 0.8, 0.422, 0.578, 0.9);
  std::erase_if(soup.triangles, [&](const auto& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return soup.points[v].x == 0; });
  });
  RunParameters parameters;
  parameters.tolerance = {0.06, false};
  parameters.effort = 0;
  check_certified(*finished_run(parameters, soup), 1, 1);
}

TEST_CASE("Right after the cut the border is at the tips of large teeth that Z passes over the rim") {
  for (const auto& [teeth, taper, percent] :
       {std::tuple{20u, 0.0, 0.5}, {20u, 0.0, 1.0}, {8u, 0.5, 0.5}, {12u, 0.5, 0.5}}) {
    CAPTURE(teeth);
    CAPTURE(percent);
    check_certified(*at_least_effort(crown(teeth, 0.6, taper), percent, Stage::rim), 0, 2);
  }
}

TEST_CASE("A strip between two parts of one loop stays") {
  for (const double width : {1.0, 2.2}) {
    CAPTURE(width);
    check_certified(*at_least_effort(square_with_tongue(0.03 * width), 3, Stage::improve), 0, 2);
  }
  check_certified(*at_least_effort(square_with_tongue(0.066), 2, Stage::improve), 0, 2);
}

TEST_CASE("Patches with a splinter at their seam are one sheet with one loop") {
  const auto run = at_least_effort(patches_with_splinter(0.0005), 3, Stage::improve);
  CHECK(run->scene->volume->open_sides()->rim().loops().size() == 1);
  check_certified(*run, 1, 1);
}

TEST_CASE("Where holes nearly meet, and δ keeps no thickening, border and rim stay near to each other") {
  for (const unsigned seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    const auto run = at_least_effort(riddled_square(seed), 3, Stage::rim);
    CHECK(run->result->certificate.holds());
    REQUIRE(run->result->certificate.border.has_value());
    CHECK(run->result->certificate.border->to_rim <= run->scene->delta);
    CHECK(run->result->certificate.border->from_rim <= run->scene->delta);
  }
}

TEST_CASE("A loop at the end of what is narrower than Ω is thick stays") {
  TriangleSoup funnel;
  constexpr std::uint32_t around = 24, along = 24;
  for (std::uint32_t j = 0; j <= along; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const double height = static_cast<double>(j) / along, angle = 2 * std::numbers::pi * i / around;
      const double radius = 0.3 * (1 - height) * (1 - height) + 0.01;
      funnel.points.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
    }
  for (std::uint32_t j = 0; j < along; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t a = j * around + i, b = j * around + (i + 1) % around;
      funnel.triangles.push_back({a, b, b + around});
      funnel.triangles.push_back({a, b + around, a + around});
    }
  RunParameters parameters;
  parameters.tolerance = {3, true};
  parameters.until = Stage::rim;
  CompleteRun run(parameters);
  run.soup = shared(std::move(funnel));
  REQUIRE(run.run());
  const Certificate& c = run.result->certificate;
  CHECK(c.holds());
  CHECK(c.boundary_loops == 2);
}

TEST_CASE("Collapses of Γ keep Z between the places on both sides before the rim") {
  RunParameters parameters;
  parameters.tolerance = {2, true};
  parameters.until = Stage::gamma;
  CompleteRun run(parameters);
  run.soup = shared(wedge(60));
  REQUIRE(run.run());
  const BorderGate& gate = *run.scene->volume->border_gate();
  REQUIRE(gate.crossed().segments().size() > 100);
  const ZeroSet z = extract_zero_set(replayed(*run.journal));
  TriangleSoup soup;
  for (const auto& v : z.vertices) soup.points.push_back(v.position);
  for (const ZeroSet::Polygon& p : z.polygons)
    for (std::size_t k = 2; k < p.count; ++k) soup.triangles.push_back({p.v[0], p.v[k - 1], p.v[k]});
  const ClosestPointIndex facets(soup);
  std::size_t apart = 0;
  for (const auto& [below, above] : gate.crossed().segments())
    apart += facets.crossings(below, above).size() % 2 == 1;
  CHECK(apart == gate.crossed().segments().size());
}
