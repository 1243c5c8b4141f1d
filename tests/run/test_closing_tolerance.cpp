// Refusals of open soups name the smallest tolerance that closes it: a run begins there, and does not below.
#include "run/closing_tolerance.h"
#include "run/complete_run.h"
#include "tolerance/open_shapes.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// A sphere of radius 1 with a round hole at a pole.
TriangleSoup bowl(double hole_radius) {
  TriangleSoup soup;
  testing::add_sphere(soup, {0, 0, 0}, 1, 16);
  const double height = std::sqrt(1 - hole_radius * hole_radius);
  std::erase_if(soup.triangles, [&](const auto& t) {
    return soup.points[t[0]].z > height || soup.points[t[1]].z > height || soup.points[t[2]].z > height;
  });
  return soup;
}

/// The radius of what it lacks: facets go with the pole, so that it is more than asked for.
double hole_in(const TriangleSoup& bowl) {
  double radius = 1;
  for (const auto& t : bowl.triangles)
    for (const auto v : t)
      if (const Vec3 p = bowl.points[v]; p.z > 0) radius = std::min(radius, std::hypot(p.x, p.y));
  return radius;
}

/// A hilly sheet: whatever the tolerance, one walks around it.
TriangleSoup sheet() {
  constexpr std::uint32_t n = 12;
  TriangleSoup soup;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      soup.points.push_back({1.0 * x, 1.0 * y, 0.3 * ((x * 7 + y * 3) % 5)});
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      soup.triangles.push_back({a, a + 1, a + n + 2});
      soup.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  return soup;
}

/// A cone whose tip goes through a square by a tenth of its side.
TriangleSoup cone_through_square() {
  TriangleSoup soup = grid_sheet(24, [](double, double) { return true; });
  constexpr std::uint32_t around = 24;
  const auto tip = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back({0.5, 0.5, -0.1});
  for (std::uint32_t i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * i / around;
    soup.points.push_back({0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle), 0.3});
  }
  for (std::uint32_t i = 0; i < around; ++i)
    soup.triangles.push_back({tip, tip + 1 + (i + 1) % around, tip + 1 + i});
  return soup;
}

/// `sigma`: in δ; 0: by default.
std::unique_ptr<CompleteRun> refined(const TriangleSoup& soup, double percent, double sigma = 0) {
  RunParameters parameters;
  parameters.input = "soup";
  parameters.tolerance = {percent, true};
  parameters.sigma = sigma;
  parameters.until = Stage::refinement;
  auto run = std::make_unique<CompleteRun>(parameters);
  run->soup = std::make_shared<const TriangleSoup>(soup);
  return run;
}

/// The percentage after these words; 0 where they are missing.
double percentage_after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  return at == std::string::npos ? 0 : std::stod(text.substr(at + words.size()));
}

} // namespace

TEST_CASE("A hole is closed by the tolerance that the refusal names, and by none clearly below") {
  for (const double hole : {0.25, 0.45}) {
    CAPTURE(hole);
    const TriangleSoup soup = bowl(hole);
    const auto open = refined(testing::exploded(soup, 0.98), 5);
    REQUIRE_FALSE(open->run());
    REQUIRE(open->error.has_value());
    CHECK(open->error->code == ErrorCode::open_surface);
    CHECK(open->error->message.find("open surface near (") != std::string::npos);
    CAPTURE(open->error->remedy);
    const double named =
        percentage_after(open->error->remedy, "The smallest tolerance that closes it is about ");
    REQUIRE(named > 5);
    // δ' has to reach the middle of the hole.
    const double reach = named / 100 * 2 * 0.95;
    CHECK(reach > 0.95 * hole_in(soup));
    CHECK(reach < 1.15 * hole_in(soup));
    CHECK(refined(testing::exploded(soup, 0.98), named)->run());
    CHECK_FALSE(refined(testing::exploded(soup, 0.98), 0.93 * named)->run());
  }
}

TEST_CASE("A sheet is said to be closed by nothing") {
  const auto open = refined(testing::exploded(sheet(), 0.98), 3);
  REQUIRE_FALSE(open->run());
  REQUIRE(open->error.has_value());
  CHECK(open->error->remedy.starts_with("No tolerance up to 50% of the longest edge closes it."));
}

TEST_CASE(
    "Of sheets that cross the smallest tolerance is named at which a run begins, or that there is none") {
  const TriangleSoup soup = cone_through_square();
  const auto crossing = refined(soup, 1.5);
  REQUIRE_FALSE(crossing->run());
  REQUIRE(crossing->error.has_value());
  CHECK(crossing->error->message.find("sheets cross or branch near (") != std::string::npos);
  const std::string& remedy = crossing->error->remedy;
  CAPTURE(remedy);
  const double named =
      percentage_after(remedy, "The smallest larger tolerance at which a run begins is about ");
  if (named > 0) {
    CHECK(refined(soup, named)->run());
    CHECK_FALSE(refined(soup, 0.93 * named)->run());
  } else {
    CHECK(remedy.ends_with("of the longest edge takes it in."));
  }
}

TEST_CASE("Sheets that cross are refused however few the samples are") {
  const auto crossing = refined(cone_through_square(), 1.5, 0.9);
  REQUIRE_FALSE(crossing->run());
  REQUIRE(crossing->error.has_value());
  CHECK(crossing->error->code == ErrorCode::joined_sheets);
}

TEST_CASE("A refusal that advises a smaller tolerance says so where the input is refused there") {
  const auto at = [](const TriangleSoup& soup, double percent) {
    const auto run = refined(soup, percent);
    REQUIRE(run->prepare());
    const Scene& scene = *run->scene;
    ToleranceVolume::Options options;
    options.delta = scene.delta;
    const Error told{ErrorCode::unsupported, "Parts lie too near to each other.", "Use a smaller tolerance."};
    return with_smaller_tolerance(told, {scene.field, scene.input_topology, 2, options}, run->parameters,
                                  run->control);
  };
  CHECK(at(grid_sheet(8, [](double, double) { return true; }), 6).remedy == "Use a smaller tolerance.");
  // Where Ω takes the tip in it is taken; where not, it crosses.
  const Error crossing = at(cone_through_square(), 11);
  CHECK(crossing.code == ErrorCode::unsupported);
  CHECK(crossing.message == "Parts lie too near to each other.");
  CHECK(crossing.remedy.starts_with("Mend the input: a smaller tolerance does not help, as at "));
  CHECK(crossing.remedy.find("sheets cross or branch near (") != std::string::npos);
}

TEST_CASE("A run that is refused after its refinement has status 3, one that failed otherwise 1") {
  RunResult result;
  CHECK(result.exit_status() == 1); // not certified
  result.failure = Error{ErrorCode::unsupported, "Z leaves Ω.", ""};
  result.last_stage = Stage::rim;
  CHECK(result.refused());
  CHECK(result.exit_status() == 3);
  result.last_stage = Stage::tessellation;
  CHECK_FALSE(result.refused());
  CHECK(result.exit_status() == 1);
  result.failure = Error{ErrorCode::internal, "An invariant does not hold.", ""};
  CHECK_FALSE(result.refused());
  CHECK(result.exit_status() == 1);
  result.end = RunResult::End::stopped;
  CHECK(result.exit_status() == 4);
}

TEST_CASE("The search ends when it is told to") {
  const auto open = refined(testing::exploded(bowl(0.45), 0.98), 5);
  bool searching = false;
  std::size_t afterwards = 0;
  open->control.on_progress([&](std::string_view part, double) {
    if (searching) ++afterwards;
    if (part != "tolerance that closes the input") return;
    searching = true;
    open->control.cancel();
  });
  REQUIRE_FALSE(open->run());
  REQUIRE(open->error.has_value());
  CHECK(searching);
  CHECK(afterwards < 5);
  CHECK(open->error->message.find("open surface near (") != std::string::npos);
  CHECK(open->error->remedy.find("A larger tolerance closes gaps") == 0);
}
