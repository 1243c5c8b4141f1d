// Whole runs on open surfaces that no edges tell of: points and loose triangles, whose rim is found by balls.
#include "input/gallery_shapes.h"
#include "journal/digest.h"
#include "journal/playback.h"
#include "mesh/validity.h"
#include "run/open_run_checks.h"
#include "run/report.h"
#include "run/statistics.h"
#include "support/clouds.h"
#include "tolerance/open_shapes.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace isoscope;
using namespace isoscope::test;
using namespace isoscope::testing;

namespace {

std::unique_ptr<CompleteRun> run_of(TriangleSoup soup, Tolerance tolerance) {
  RunParameters parameters;
  parameters.tolerance = tolerance;
  parameters.until = Stage::zero_set;
  auto run = std::make_unique<CompleteRun>(parameters);
  run->soup = shared(std::move(soup));
  return run;
}

std::unique_ptr<CompleteRun> run_of(std::vector<Vec3> points, Tolerance tolerance = {.automatic = true}) {
  TriangleSoup soup;
  soup.points = std::move(points);
  return run_of(std::move(soup), tolerance);
}

Tolerance absolute(double delta) {
  return {.value = delta, .percent = false};
}

/// Points of a sphere with noise above a height, without those around its top up to a distance.
std::vector<Vec3> half_sphere(std::size_t n, double noise_size, double hole) {
  Random random(7);
  std::vector<Vec3> points;
  while (points.size() < n) {
    const Vec3 p = random.direction();
    if (p.z > 0 && distance(p, {0, 0, 1}) >= hole) points.push_back(p + noise(random, noise_size));
  }
  return points;
}

std::vector<Vec3> square(std::size_t n, double noise_size) {
  Random random(8);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(random.in_box({{-1, -1, 0}, {1, 1, 0}}) + noise(random, noise_size));
  return points;
}

/// Points of a strip around a circle, turned by so many half turns on the way.
std::vector<Vec3> strip_points(std::size_t n, int half_turns, double width) {
  Random random(9);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double u = random.between(0, 2 * std::numbers::pi), v = random.between(-width / 2, width / 2);
    const double turn = 0.5 * half_turns * u, r = 1 + v * std::cos(turn);
    points.push_back({r * std::cos(u), r * std::sin(u), v * std::sin(turn)});
  }
  return points;
}

void check_sheet(CompleteRun& run, long chi, std::size_t loops, std::size_t components = 1) {
  const bool done = run.run();
  if (run.error) FAIL(run.error->line());
  REQUIRE(done);
  for (const std::string& failure : run.result->certificate.failures) MESSAGE(failure);
  check_certified(run, chi, loops, components);
  CHECK(run.result->exit_status() == 0);
  REQUIRE(run.scene->sheets.has_value());
  CHECK(run.scene->sheets->boundary_samples > 0);
  CHECK(run.scene->sheets->boundary_samples < run.scene->sheets->samples);
  CHECK(!run.scene->samples->over_rim.empty());
  CHECK(check_complex(replayed(*run.journal)).empty());
}

/// The largest distance of the rim from a circle of radius 1 around the z axis.
double off_circle(const Rim& rim, double z) {
  double most = 0;
  for (const RimPiece& piece : rim.pieces())
    if (std::abs(piece.a.z - z) < 0.3)
      most = std::max(most, std::hypot(std::hypot(piece.a.x, piece.a.y) - 1, piece.a.z - z));
  return most;
}

} // namespace

TEST_CASE("Half a sphere of noisy points is a disc whose border keeps to its rim") {
  const auto run = run_of(half_sphere(2500, 0.01, 0), absolute(0.2));
  check_sheet(*run, 1, 1);
  const Rim& rim = run->scene->volume->open_sides()->rim();
  CHECK(rim.loops()[0].length == doctest::Approx(2 * std::numbers::pi).epsilon(0.05));
  CHECK(rim.loops()[0].flatness < 0.05);
  CHECK(off_circle(rim, 0) < 0.75 * run->scene->delta); // points are averaged with their neighbours
  const auto report = nlohmann::json::parse(
      report_json(run->parameters, *run->scene, *run->result, gather_statistics(*run->journal)));
  CHECK(report["rim"]["ball_test"]["gamma"] == 2);
  CHECK(report["rim"]["ball_test"]["boundary_samples"] == run->scene->sheets->boundary_samples);
  CHECK(report["parameters"]["gamma"] == "auto");
}

TEST_CASE("A hole in points stays, a square and a tube are what they are, at the tolerance that is found") {
  SUBCASE("half a sphere with a hole") {
    check_sheet(*run_of(half_sphere(2500, 0.01, 0.6)), 0, 2);
  }
  SUBCASE("a square") {
    check_sheet(*run_of(square(2500, 0.005)), 1, 1);
  }
  SUBCASE("a strip around a circle") {
    check_sheet(*run_of(strip_points(2500, 0, 1.2)), 0, 2);
  }
  SUBCASE("a strip of two half turns") {
    check_sheet(*run_of(strip_points(4000, 2, 1)), 0, 2);
  }
}

TEST_CASE(
    "Points with one side only, points that fill a ball and points of a curve are refused with a place") {
  const auto refused = [](std::vector<Vec3> points, double delta, const std::string& words) {
    const auto run = run_of(std::move(points), absolute(delta));
    run->parameters.gamma.gamma = 2;
    REQUIRE_FALSE(run->prepare());
    CHECK(run->error->code == ErrorCode::open_surface);
    CAPTURE(run->error->line());
    CHECK(run->error->message.find(words) != std::string::npos);
    CHECK(run->error->message.find("near (") != std::string::npos);
    CHECK(!run->error->remedy.empty());
  };
  Random random(4);
  refused(strip_points(8000, 1, 1), 0.115, "sides of the points cannot be told");
  std::vector<Vec3> ball, curve;
  while (ball.size() < 3000)
    if (const Vec3 p = random.in_box({{-1, -1, -1}, {1, 1, 1}}); length(p) < 1) ball.push_back(p);
  refused(ball, 0.3, "No sheet with two sides");
  for (int i = 0; i < 1000; ++i) curve.push_back({0.01 * i, 0, 0});
  refused(curve, 0.1, "No sheet with two sides");
}

TEST_CASE("Points that lie too far apart for Ω to hang together are refused with what would join them") {
  // A square of points that are 0.04 apart, its middle with a dense patch that Ω joins at once.
  std::vector<Vec3> points;
  for (int i = -25; i <= 25; ++i)
    for (int j = -25; j <= 25; ++j) points.push_back({0.04 * i, 0.04 * j, 0});
  const std::vector<Vec3> sparse = points;
  for (int i = -5; i <= 5; ++i)
    for (int j = -5; j <= 5; ++j) points.push_back({0.01 + 0.005 * i, 0.01 + 0.005 * j, 0});
  for (const double delta : {0.01, 0.04}) {
    CAPTURE(delta);
    const auto run = run_of(points, absolute(delta));
    REQUIRE_FALSE(run->prepare());
    CHECK(run->error->code == ErrorCode::open_surface);
    CAPTURE(run->error->line());
    CHECK(run->error->message.find("do not hang together") != std::string::npos);
    CHECK(run->error->message.find("near (") != std::string::npos);
    const std::string words = "From δ = ";
    const std::size_t at = run->error->remedy.find(words);
    REQUIRE(at != std::string::npos);
    const double joining = std::stod(run->error->remedy.substr(at + words.size()));
    CHECK(joining > delta);
    CHECK(joining < 0.08);
    const auto larger = run_of(sparse, absolute(1.5 * joining));
    check_sheet(*larger, 1, 1);
  }
}

TEST_CASE("A sheet that ends in a clump of points has no two sides there, and is refused with its place") {
  Random random(11);
  std::vector<Vec3> points = square(3000, 0.002);
  while (points.size() < 3800)
    if (const Vec3 p = random.in_box({{-1, -1, -1}, {1, 1, 1}}); length(p) < 1)
      points.push_back(0.45 * p + Vec3{0.9, 0, 0});
  const auto run = run_of(std::move(points), absolute(0.1));
  run->parameters.gamma.gamma = 2;
  REQUIRE_FALSE(run->prepare());
  CHECK(run->error->code == ErrorCode::open_surface);
  CAPTURE(run->error->line());
  CHECK(run->error->message.find("find one side only") != std::string::npos);
  CHECK(run->error->message.find("near (") != std::string::npos);
}

TEST_CASE("A closed part beside a sheet stays closed, where the sheet is asked for") {
  Random random(5);
  std::vector<Vec3> points = half_sphere(2500, 0.01, 0);
  for (const Vec3 p : sphere_points(random, 3000, 0.8, 0.01)) points.push_back(p + Vec3{2.6, 0, 0.5});
  const auto refused = run_of(points, absolute(0.2));
  REQUIRE_FALSE(refused->prepare());
  CHECK(refused->error->remedy.find("--gamma 2") != std::string::npos);
  const auto run = run_of(std::move(points), absolute(0.2));
  run->parameters.gamma.gamma = 2;
  check_sheet(*run, 1 + 2, 1, 2);
}

TEST_CASE("Closed points take no notice of γ, and open ones are refused without it") {
  Random random(6);
  const std::vector<Vec3> sphere = sphere_points(random, 1500, 1, 0.01);
  const auto as_before = run_of(sphere), asked = run_of(sphere);
  as_before->parameters.gamma.gamma = BallTestFactor::off;
  REQUIRE(as_before->run());
  REQUIRE(asked->run());
  CHECK(digest(*as_before->journal) == digest(*asked->journal));
  CHECK_FALSE(asked->scene->sheets.has_value());
  const auto refused = run_of(half_sphere(2500, 0.01, 0));
  refused->parameters.gamma.gamma = BallTestFactor::off;
  REQUIRE_FALSE(refused->prepare());
  CHECK(refused->error->code == ErrorCode::open_surface);
  CHECK(refused->error->remedy.find("--gamma") != std::string::npos);
}

TEST_CASE("Loose triangles of an open sheet are taken with γ, and refused with a word on it without") {
  const TriangleSoup loose = exploded(make_hemisphere(16), 0.9);
  const auto refused = run_of(loose, absolute(0.15));
  REQUIRE_FALSE(refused->prepare());
  CHECK(refused->error->remedy.find("--gamma 2") != std::string::npos);
  const auto run = run_of(loose, absolute(0.15));
  run->parameters.gamma.gamma = 2;
  check_sheet(*run, 1, 1);
  CHECK(off_circle(run->scene->volume->open_sides()->rim(), 0) < 0.5 * run->scene->delta);
}
