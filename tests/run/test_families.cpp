// Whole runs on families of inputs with known topology: handles, nesting, many parts, thin walls, damaged
// soups.
#include "input/gallery.h"
#include "run/complete_run.h"
#include "run/voxel_soup.h"
#include "support/models.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// To the end with the least effort, as validity does not depend on it.
std::unique_ptr<CompleteRun> run_soup(TriangleSoup soup, double delta) {
  auto run = std::make_unique<CompleteRun>(std::move(soup), delta);
  run->parameters.input = "soup";
  run->parameters.effort = 0;
  run->run();
  return run;
}

} // namespace

namespace {

/// A plate with n × n holes.
void check_plate(int n) {
  const auto holes = [](int x, int y, int) { return x % 2 == 0 || y % 2 == 0; };
  const auto run = run_soup(voxel_surface({2 * n + 1, 2 * n + 1, 1}, holes), 0.18);
  REQUIRE_MESSAGE(run->result.has_value(), (run->error ? run->error->line() : ""));
  const Certificate& c = run->result->certificate;
  CHECK(c.holds());
  CHECK(c.components == 1);
  CHECK(c.euler_characteristic == 2 - 2 * n * n);
}

} // namespace

TEST_CASE("A plate with nine holes keeps its genus") {
  check_plate(3);
}

TEST_CASE("A plate with forty-nine holes keeps its genus" * doctest::test_suite("soak")) {
  check_plate(7);
}

TEST_CASE("Nested shells and many parts keep their number, whatever the orientation of their faces") {
  // A cube with a cavity that holds a cube.
  const auto shells = [](int x, int y, int z) {
    const auto ring = std::max({std::abs(x - 3), std::abs(y - 3), std::abs(z - 3)});
    return ring == 3 || ring <= 1;
  };
  for (const bool flip : {false, true}) {
    TriangleSoup soup = voxel_surface({7, 7, 7}, shells);
    std::mt19937 random(5);
    if (flip)
      for (auto& t : soup.triangles)
        if (random() % 2 != 0) std::swap(t[0], t[1]);
    const auto run = run_soup(std::move(soup), 0.2);
    REQUIRE_MESSAGE(run->result.has_value(), (run->error ? run->error->line() : ""));
    CHECK(run->result->certificate.holds());
    CHECK(run->result->certificate.components == 3);
    CHECK(run->result->certificate.euler_characteristic == 6);
  }
  const auto lattice = [](int x, int y, int z) { return x % 2 == 0 && y % 2 == 0 && z % 2 == 0; };
  const auto run = run_soup(voxel_surface({3, 3, 3}, lattice), 0.15);
  REQUIRE(run->result.has_value());
  CHECK(run->result->certificate.holds());
  CHECK(run->result->certificate.components == 8);
  CHECK(run->result->certificate.euler_characteristic == 16);
  CHECK(run->result->mesh.points.size() >= 8 * 4);
  CHECK(run->result->mesh.points.size() <= 8 * 9);
}

TEST_CASE("A slot that the tolerance volume closes and one that it leaves are both kept") {
  const auto slotted = [](int x, int, int z) { return z != 1 || x == 0 || x == 5; };
  for (const double thick : {0.3, 0.8}) {
    TriangleSoup soup = voxel_surface({6, 3, 3}, slotted); // a tunnel along y
    for (Vec3& p : soup.points)
      if (p.z >= 2) p.z += thick - 1;
    const auto run = run_soup(std::move(soup), 0.2);
    REQUIRE_MESSAGE(run->result.has_value(), (run->error ? run->error->line() : ""));
    const Certificate& c = run->result->certificate;
    // The walls deep in a slot that Ω closes would be far from the result: points in it are held.
    CHECK((run->scene->volume->held() > 0) == (thick < 0.4));
    CHECK(c.covers);
    CHECK(c.holds());
    CHECK(c.components == 1);
    if (thick > 0.4) CHECK(c.euler_characteristic == 0);
    CHECK(c.within_tolerance);
  }
}

TEST_CASE("A soup with small holes, torn and turned faces comes out whole") {
  const auto made = make_gallery_model("torus");
  REQUIRE(made.ok());
  const TriangleSoup& whole = *made;
  TriangleSoup torn;
  std::mt19937 random(11);
  for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
    if (i % 97 == 13) continue; // a hole
    std::array<std::uint32_t, 3> t{};
    for (std::size_t k = 0; k < 3; ++k) {
      t[k] = static_cast<std::uint32_t>(torn.points.size());
      torn.points.push_back(whole.points[whole.triangles[i][k]]);
    }
    if (random() % 2) std::swap(t[0], t[1]);
    torn.triangles.push_back(t);
  }
  const Box3 box = torn.bounds();
  const auto run = run_soup(std::move(torn), 0.03 * box.longest_edge());
  REQUIRE_MESSAGE(run->result.has_value(), (run->error ? run->error->line() : ""));
  CHECK(run->result->certificate.holds());
  CHECK(run->result->certificate.components == 1);
  CHECK(run->result->certificate.euler_characteristic == 0);
}

TEST_CASE("Holes that the tolerance volume closes are gone, others make an open surface or are named") {
  const auto model = demo_model("elephant-with-holes.off");
  if (!model) return;
  for (const double percent : {4.0, 2.0}) {
    RunParameters parameters;
    parameters.input = model->string();
    parameters.tolerance = {percent, true};
    parameters.effort = 0;
    parameters.cover.reset(); // ears and trunk are thinner than 2 δ at 4 %
    if (percent < 3) parameters.until = Stage::refinement;
    CompleteRun run(parameters);
    run.run();
    if (percent > 3) {
      REQUIRE(run.result.has_value());
      CHECK(run.scene->volume->open_sides() == nullptr);
      CHECK(run.result->certificate.holds());
    } else if (run.error) {
      CHECK(run.error->message.find("near (") != std::string::npos);
    } else {
      REQUIRE(run.scene->volume->open_sides() != nullptr);
      CHECK(!run.scene->volume->open_sides()->rim().loops().empty());
    }
  }
}

TEST_CASE("A soup that closes although it is no manifold has the sides of its winding number") {
  const auto model = demo_model("cow.off");
  if (!model) return;
  RunParameters parameters;
  parameters.input = model->string();
  parameters.tolerance = {2.0, true};
  parameters.until = Stage::refinement;
  CompleteRun run(parameters);
  REQUIRE(run.run());
  CHECK(!run.scene->input_topology.closed_manifold);
  CHECK(run.scene->volume->sides().rule() == SideRule::winding);
  CHECK(run.scene->thickening_note.empty());
  const Certificate& c = run.result->certificate;
  CHECK(c.topology_as_expected());
  CHECK(c.euler_characteristic == 2);
  // Its tail and horns are thinner than 2 δ.
  CHECK(run.scene->volume->held() > 0);
  CHECK(c.covers);
  // What a result lacks of them is told, the farthest first, where nothing is held.
  parameters.cover = 1.9;
  CompleteRun lost(parameters);
  REQUIRE(lost.run());
  CHECK(!lost.result->certificate.covers);
  const std::vector<UncoveredPlace>& places = lost.result->certificate.uncovered;
  REQUIRE(places.size() > 1);
  CHECK(places[0].distance > places[1].distance);
}

TEST_CASE("One model at tolerances from 2 to 8 percent is certified at each, with fewer vertices") {
  const auto model = demo_model("sphere.off");
  if (!model) return;
  std::size_t before = 1u << 30;
  for (const double percent : {2.0, 4.0, 8.0}) {
    RunParameters parameters;
    parameters.input = model->string();
    parameters.tolerance = {percent, true};
    parameters.effort = 0;
    parameters.cover.reset(); // ears and trunk are thinner than 2 δ at 4 %
    CompleteRun run(parameters);
    REQUIRE(run.run());
    CHECK(run.result->certificate.holds());
    CHECK(run.result->mesh.points.size() < before);
    before = run.result->mesh.points.size();
  }
}

TEST_CASE("A plate out of a box that is a hundred and sixty δ wide and thinner than δ is whole") {
  TriangleSoup soup;
  isoscope::testing::add_box(soup, {0, 0, 0}, {0.2, 1.3, 0.2});
  isoscope::testing::add_box(soup, {0.1, 0, 0.1}, {1.4, 1.3, 0.105});
  const auto run = run_soup(soup, 0.008);
  REQUIRE_MESSAGE(run->result.has_value(), (run->error ? run->error->line() : ""));
  const Certificate& c = run->result->certificate;
  CHECK_MESSAGE(c.holds(), (c.failures.empty() ? "" : c.failures.front()));
  CHECK(c.euler_characteristic == 2);
}
