// Whole runs on open surfaces: loops and χ of the input, a border within δ of the rim both ways, holes
// filled, one-sided sheets refused.
#include "input/gallery.h"
#include "journal/playback.h"
#include "mesh/validity.h"
#include "run/open_run_checks.h"
#include "tolerance/open_shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

using namespace isoscope;
using namespace isoscope::test;

namespace {

RunParameters open_parameters(double percent) {
  RunParameters parameters;
  parameters.tolerance = {percent, true};
  parameters.until = Stage::rim;
  return parameters;
}

std::unique_ptr<CompleteRun> finished(TriangleSoup soup, double percent, const char* fill = "none") {
  RunParameters parameters = open_parameters(percent);
  parameters.fill.holes = fill;
  return finished_run(parameters, std::move(soup));
}

} // namespace

TEST_CASE("Sheets come out with the loops and the Euler characteristic of the input") {
  struct Case {
    const char* name;
    TriangleSoup soup;
    double percent;
    long chi;
    std::size_t loops;
  };
  const Case cases[] = {{"hemisphere", make_hemisphere(16), 3, 1, 1},
                        {"annulus", strip(0), 3, 0, 2},
                        {"square with a hole", square_with_hole(), 3, 0, 2},
                        {"slit square", slit_square(), 4, 1, 1},
                        {"ball with four holes", ball_with_holes(), 3, -2, 4},
                        {"strip of two half turns", strip(2), 3, 0, 2},
                        {"needle", square_with_needle(), 3, 1, 1},
                        {"flap", square_with_flap(0.01), 3, 1, 1},
                        {"jagged square", jagged_square(14, 7), 2, 1, 1}};
  for (const Case& c : cases) {
    CAPTURE(std::string(c.name));
    const auto run = finished(c.soup, c.percent);
    check_certified(*run, c.chi, c.loops);
    CHECK(!run->scene->samples->over_rim.empty());
    CHECK(check_complex(replayed(*run->journal)).empty());
  }
}

TEST_CASE("Strips of little more than twice the tolerance between holes stay, on flat and on bent sheets") {
  constexpr double delta = 0.03; // of a unit square
  const auto bent = [](double x, double y) { return 0.3 * x * x - 0.2 * y * y + 0.1 * x * y; };
  for (const bool is_bent : {false, true})
    for (const double strip_width : {2.2, 2.5, 3.0}) {
      CAPTURE(is_bent);
      CAPTURE(strip_width);
      const double half = strip_width * delta / 2;
      const auto has = [&](double x, double y) {
        const bool in_window = std::abs(y - 0.5) < 0.2 && std::abs(x - 0.5) > half && std::abs(x - 0.5) < 0.3;
        return !in_window;
      };
      TriangleSoup sheet = grid_sheet(200, has);
      if (is_bent)
        for (Vec3& p : sheet.points) p.z = bent(p.x, p.y);
      check_certified(*finished(std::move(sheet), 100 * delta), -1, 3);
    }
}

TEST_CASE("What lies between the turns of a rolled sheet, where both its sides meet, is not refined") {
  TriangleSoup sheet = grid_sheet(48, [](double, double) { return true; });
  for (Vec3& p : sheet.points) {
    const double angle = 4.4 * std::numbers::pi * p.x, radius = 0.3 + 0.75 * p.x;
    p = {radius * std::cos(angle), radius * std::sin(angle), p.y};
  }
  const auto run = finished(std::move(sheet), 3);
  check_certified(*run, 1, 1);
  std::size_t insertions = 0;
  for (Step k = 0; k < run->journal->steps(); ++k)
    insertions += run->journal->events()[run->journal->operations()[k].event].stage == Stage::refinement;
  CHECK(insertions < 2500); // 10 times as many where the sides of a turn are told from the other turn's
}

TEST_CASE("The cut is a stage of its own that is stepped through both ways") {
  const auto run = finished(make_hemisphere(12), 4);
  Playback playback(run->journal);
  std::size_t splits = 0, cuts = 0;
  for (Step k = 0; k < run->journal->steps(); ++k) {
    const Event& e = run->journal->events()[run->journal->operations()[k].event];
    if (e.stage != Stage::rim) continue;
    splits += e.kind == EventKind::split;
    cuts += e.kind == EventKind::cut;
    playback.seek(k);
    const Complex before = playback.complex();
    playback.seek(k + 1);
    const ZeroSet z = extract_zero_set(playback.complex());
    CHECK(run->journal->operations()[k].figures.zero_set_vertices == z.vertices.size());
    CHECK(z.boundary_loops() == (e.kind == EventKind::cut ? 1u : 0u));
    playback.seek(k);
    CHECK(playback.complex() == before);
  }
  CHECK(splits > 10);
  CHECK(cuts == 1);
}

TEST_CASE("Gaps of an open surface that Ω closes stay open") {
  for (const double gap : {0.6, 1.0}) { // in δ
    CAPTURE(gap);
    const auto run = finished(open_comb(2, 0.2, gap * 0.03), 3);
    check_certified(*run, 1, 1);
    // Before Z is cut no other number could have told that it has handles.
    std::size_t points = 0;
    for (std::size_t i = 0; i < run->journal->events().size(); ++i) {
      const Event& e = run->journal->events()[i];
      points += e.kind == EventKind::insertion && e.condition == Condition::topology &&
                e.reason == Reason::crossing_simplex;
    }
    CHECK(points > 0);
  }
}

TEST_CASE("A hole that Ω does not close is one, however narrow") {
  constexpr double percent = 5, delta = percent / 100 * 2;
  for (const double radius :
       {1.05, 1.25, 1.4, 1.6}) { // in δ; main cells of the octree see the last one alone
    CAPTURE(radius);
    check_certified(*finished(ball_with_hole(radius * delta), percent), 1, 1);
  }
  const auto closed = finished(ball_with_hole(0.9 * delta), percent);
  CHECK(closed->result->certificate.holds());
  CHECK(closed->result->certificate.euler_characteristic == 2);
}

TEST_CASE("A tube that is narrower than Ω is thick stays one") {
  TriangleSoup tube;
  constexpr std::uint32_t around = 16, along = 10;
  for (std::uint32_t j = 0; j <= along; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const double t = 2 * std::numbers::pi * i / around;
      tube.points.push_back({static_cast<double>(j) / along, 0.05 * std::cos(t), 0.05 * std::sin(t)});
    }
  for (std::uint32_t j = 0; j < along; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t a = j * around + i, b = j * around + (i + 1) % around;
      tube.triangles.push_back({a, a + around, b});
      tube.triangles.push_back({b, a + around, b + around});
    }
  const auto run = finished_run(open_parameters(10), tube);
  const Certificate& c = run->result->certificate;
  CHECK(c.boundary_loops == 2);
  CHECK(c.euler_characteristic == 0);
  CHECK(c.topology == Certificate::Topology::as_expected); // though Ω is a ball
  CHECK(c.holds());
}

TEST_CASE("A strip of one side is refused with the place") {
  for (const int half_turns : {1, 3}) {
    CompleteRun run(open_parameters(3));
    run.soup = shared(strip(half_turns));
    REQUIRE_FALSE(run.run());
    REQUIRE(run.error.has_value());
    CHECK(run.error->code == ErrorCode::open_surface);
    CHECK(run.error->message.find("one side only") != std::string::npos);
    CHECK(run.error->message.find("near (") != std::string::npos);
  }
}

TEST_CASE("A sheet of patches that run either way is one sheet") {
  // A dented square in two patches with other triangles at their seam.
  TriangleSoup soup;
  add_dented_patch(soup, 0, 0.6, 9, 15);
  add_dented_patch(soup, 0.6, 1, 6, 19, true);
  check_certified(*finished(soup, 3), 1, 1);
}

TEST_CASE("An open body and a closed one are done each in its way") {
  TriangleSoup both = make_hemisphere(12);
  TriangleSoup ball = make_sphere(3);
  for (Vec3& p : ball.points) p = Vec3{3, 0, 0.3} + 0.7 * p;
  append(both, ball);
  const auto run = finished(both, 2);
  check_certified(*run, 3, 1, 2);

  // The same with the ball inside of the bowl.
  TriangleSoup inside = make_hemisphere(12);
  for (Vec3& p : ball.points) p = 0.5 * (p - Vec3{3, 0, 0.3}) + Vec3{0, 0, 0.3};
  append(inside, ball);
  check_certified(*finished(inside, 3), 3, 1, 2);
}

TEST_CASE("Holes are filled with what Z has there, and that is no part of what is proven inside") {
  const auto kept = finished(ball_with_holes(), 3), all = finished(ball_with_holes(), 3, "all"),
             two = finished(ball_with_holes(), 3, "2,4");
  CHECK(kept->result->holes.facets.empty());
  CHECK(all->result->certificate.holds());
  CHECK(all->result->certificate.euler_characteristic == 2);
  CHECK(all->result->certificate.boundary_loops == 0);
  CHECK(all->result->certificate.closed_manifold);
  check_certified(*two, 0, 2);
  CHECK(std::count(two->result->holes.facets.begin(), two->result->holes.facets.end(), 1) > 0);
  // Which holes are flat: those of a grid are, the rim of a saddle is not.
  const auto saddle = [](double x, double y) {
    return 0.8 * (x - 0.5) * (x - 0.5) - 0.8 * (y - 0.5) * (y - 0.5);
  };
  const auto sheet = grid_sheet(
      20, [](double x, double y) { return std::abs(x - 0.5) > 0.2 || std::abs(y - 0.5) > 0.2; }, saddle);
  CompleteRun bent(open_parameters(3));
  bent.soup = shared(sheet);
  REQUIRE(bent.prepare());
  const auto loops = bent.scene->volume->open_sides()->rim().loops();
  REQUIRE(loops.size() == 2);
  for (const RimLoop& loop : loops) CHECK((loop.flatness > 0.1) == (loop.length > 2));
}

TEST_CASE("What fills the holes of the final mesh has no vertices of its own") {
  const auto finish = [](const char* fill) {
    CompleteRun run(gallery_parameters("hemisphere"));
    run.parameters.until = Stage::improve;
    run.parameters.effort = 0;
    run.parameters.fill.holes = fill;
    if (!run.run()) FAIL(run.error->line());
    for (const std::string& failure : run.result->certificate.failures) MESSAGE(failure);
    return std::move(*run.result);
  };
  const RunResult kept = finish("none"), filled = finish("all");
  CHECK(kept.certificate.holds());
  CHECK(kept.certificate.boundary_loops == 1);
  CHECK(filled.certificate.holds());
  CHECK(filled.certificate.closed_manifold);
  CHECK(filled.certificate.euler_characteristic == 2);
  CHECK(filled.certificate.intersection_free);
  CHECK(filled.mesh.points == kept.mesh.points);
  CHECK(filled.mesh.triangles.size() == 2 * kept.mesh.points.size() - 4);
  CHECK(std::count(filled.holes.facets.begin(), filled.holes.facets.end(), 1) ==
        std::ssize(filled.mesh.triangles) - std::ssize(kept.mesh.triangles));
}

TEST_CASE("Sheets end as they were cut: known answers of the whole way" * doctest::test_suite("soak")) {
  struct Case {
    const char* name;
    TriangleSoup soup;
    double percent;
    long chi;
    std::size_t loops;
  };
  const Case cases[] = {{"hemisphere", make_hemisphere(16), 3, 1, 1},
                        {"annulus", strip(0), 3, 0, 2},
                        {"ball with four holes", ball_with_holes(), 3, -2, 4}};
  for (const Case& c : cases) {
    CAPTURE(c.name);
    CompleteRun run(open_parameters(c.percent));
    run.parameters.until = Stage::improve;
    run.parameters.effort = 0;
    run.soup = shared(c.soup);
    if (!run.run()) FAIL(run.error->line());
    check_certified(run, c.chi, c.loops);
  }
}

TEST_CASE("Bundled open models are what their cards say, at any number of threads the same") {
  for (const GalleryEntry& entry : gallery()) {
    if (entry.boundary_loops == 0) continue;
    CAPTURE(std::string(entry.name));
    CompleteRun run(gallery_parameters(std::string(entry.name)));
    run.parameters.until = Stage::rim;
    REQUIRE(run.run());
    check_certified(run, entry.euler_characteristic, entry.boundary_loops);
  }
}
