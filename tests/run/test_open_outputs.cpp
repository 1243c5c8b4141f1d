// Open results by brute force: sheets with random holes, and the bundled open models.
#include "input/gallery.h"
#include "run/open_output_check.h"
#include "run/open_run_checks.h"
#include "tolerance/open_shapes.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Without the triangles within random distances of random places of it, that lie so far apart that the holes
/// do not meet.
TriangleSoup with_random_holes(TriangleSoup soup, std::uint64_t seed, std::size_t holes, double least,
                               double most) {
  isoscope::testing::Random random(seed);
  std::vector<std::pair<Vec3, double>> taken;
  for (int tried = 0; tried < 1000 && taken.size() < holes; ++tried) {
    const Vec3 p = centroid(soup.triangle(random.below(soup.triangles.size())));
    const double r = random.between(least, most);
    const bool apart = std::all_of(taken.begin(), taken.end(), [&](const auto& hole) {
      return distance(hole.first, p) > hole.second + r + 0.5 * least + 0.2;
    });
    if (apart) taken.emplace_back(p, r);
  }
  REQUIRE(taken.size() == holes);
  std::erase_if(soup.triangles, [&](const auto& t) {
    const Vec3 c = centroid(Triangle3{soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]});
    return std::any_of(taken.begin(), taken.end(),
                       [&](const auto& hole) { return distance(c, hole.first) < hole.second; });
  });
  return soup;
}

/// The topology is promised: at sharp corners of the rim the lattice on which χ of ∂Ω is counted may be too
/// coarse, but nothing closes there.
void check(RunParameters parameters, TriangleSoup soup, long chi, std::size_t loops) {
  const auto run = finished_run(std::move(parameters), soup);
  const Certificate& c = run->result->certificate;
  CHECK(c.holds());
  CHECK(c.topology == Certificate::Topology::as_expected);
  CHECK(c.euler_characteristic == chi);
  CHECK(c.boundary_loops == loops);
  const OpenOutput found = check_open_output(soup, run->result->mesh, run->scene->delta);
  CHECK(found.manifold);
  CHECK(found.oriented);
  CHECK_FALSE(found.meets_itself);
  CHECK(found.euler_characteristic == chi);
  CHECK(found.components == 1);
  CHECK(found.loops == loops);
  CHECK(found.facets <= 1 + 2e-3);
  CHECK(found.to_rim <= 1 + 1e-9);
  // Ω closes notches of the rim that are narrower than 2δ, between two edges of it.
  CHECK(found.from_rim <= 1 + found.longest_rim_edge);
}

enum class Family { sphere, torus, hills };

/// One with so many random holes that are wider than 2δ.
void check_family(Family family, std::uint64_t seed, std::size_t holes, double percent) {
  CAPTURE(static_cast<int>(family));
  CAPTURE(seed);
  CAPTURE(percent);
  RunParameters parameters;
  parameters.tolerance = {percent, true};
  parameters.effort = 0;
  TriangleSoup whole;
  if (family == Family::sphere)
    whole = make_sphere(3);
  else if (family == Family::torus)
    whole = make_torus(1, 0.45, 40, 20);
  else
    whole = grid_sheet(
        24, [](double, double) { return true; },
        [](double x, double y) { return 0.15 * std::sin(3 * x + 1) * std::cos(4 * y); });
  if (family == Family::hills)
    for (Vec3& p : whole.points) p = 3.0 * p;
  const TriangleSoup soup = with_random_holes(std::move(whole), seed, holes, 0.25, 0.35);
  // Holes of hills may reach their edge, and are no loops then.
  const OpenOutput is = check_open_output(soup, {soup.points, soup.triangles}, 1);
  if (family != Family::hills) {
    CHECK(is.loops == holes);
    CHECK(is.euler_characteristic == (family == Family::sphere ? 2 : 0) - static_cast<long>(holes));
  }
  check(parameters, soup, is.euler_characteristic, is.loops);
}

} // namespace

TEST_CASE("Sheets with random holes are what they are by brute force too") {
  check_family(Family::sphere, 1, 2, 4);
  // Here the lattice counts a tunnel too many.
  check_family(Family::sphere, 2, 4, 2);
}

TEST_CASE("Bundled open models are what they are by brute force too" * doctest::test_suite("soak")) {
  for (const GalleryEntry& entry : gallery()) {
    if (entry.boundary_loops == 0) continue;
    const auto soup = make_gallery_model(entry.name);
    REQUIRE(soup.ok());
    if (soup->triangles.empty()) continue;
    CAPTURE(std::string(entry.name));
    RunParameters parameters;
    parameters.tolerance = {entry.tolerance_percent, true};
    parameters.effort = 0;
    check(parameters, *soup, entry.euler_characteristic, entry.boundary_loops);
  }
}

TEST_CASE("Many sheets with random holes" * doctest::test_suite("soak")) {
  for (const Family family : {Family::sphere, Family::torus, Family::hills})
    for (const double percent : {2.0, 3.0, 4.0})
      for (std::uint64_t seed = 1; seed <= 4; ++seed) check_family(family, seed, 4, percent);
}
