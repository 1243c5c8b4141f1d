// Models of any size, and models far from the origin: a certified mesh, or a sentence that says which digits
// are lost.
#include "base/snap.h"
#include "run/complete_run.h"
#include "run/coordinate_check.h"
#include "run/report.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// An egg, so that no direction is like another.
TriangleSoup egg(double size, Vec3 at = {}) {
  TriangleSoup soup;
  testing::add_sphere(soup, {0, 0, 0}, 1, 12);
  for (Vec3& p : soup.points) p = at + size * Vec3{0.7 * p.x, 0.5 * p.y, p.z};
  return soup;
}

std::unique_ptr<CompleteRun> run_of(TriangleSoup soup, Tolerance tolerance) {
  RunParameters parameters;
  parameters.input = "soup";
  parameters.tolerance = tolerance;
  parameters.effort = 0;
  auto run = std::make_unique<CompleteRun>(parameters);
  run->soup = std::make_shared<const TriangleSoup>(std::move(soup));
  run->run();
  return run;
}

bool warned_of(const Scene& scene, const std::string& words) {
  for (const ParameterWarning& w : scene.warnings)
    if (w.message.find(words) != std::string::npos) return true;
  return false;
}

} // namespace

TEST_CASE(
    "A model of any size has a certified mesh, and one far from 1 is told of the digits that are lost") {
  const auto near_one = run_of(egg(1), {4, true});
  REQUIRE(near_one->result.has_value());
  REQUIRE(near_one->result->certificate.holds());
  CHECK_FALSE(warned_of(*near_one->scene, "digit"));
  CHECK(near_one->result->normals.mean > 1);
  for (const int exponent : {-192, -100, -30, 40, 166, 196}) {
    CAPTURE(exponent);
    const double size = std::ldexp(1.0, exponent);
    const auto run = run_of(egg(size), {4, true});
    REQUIRE_MESSAGE(run->result.has_value(), (run->error ? run->error->line() : ""));
    CHECK(run->result->certificate.holds());
    CHECK(run->result->mesh.points.size() < 1.3 * near_one->result->mesh.points.size());
    CHECK(run->result->normals.mean == doctest::Approx(near_one->result->normals.mean).epsilon(0.3));
    const bool far = std::abs(exponent) > 90;
    CHECK(warned_of(*run->scene, "lose their digits beyond the range of a double") == far);
    if (far) continue;
    // Powers of two change no digit of any number.
    CHECK(run->result->mesh.triangles == near_one->result->mesh.triangles);
    for (std::size_t i = 0; i < run->result->mesh.points.size(); ++i)
      CHECK(run->result->mesh.points[i] == size * near_one->result->mesh.points[i]);
  }
}

TEST_CASE("Far from the origin the run says how many digits are left, and refuses where they are too few") {
  const auto far = run_of(egg(1, {1e7, -1e7, 1e7}), {4, true});
  REQUIRE(far->result.has_value());
  CHECK(far->result->certificate.holds());
  CHECK(warned_of(*far->scene, "of the 16 digits of its coordinates 9 are left at its size"));
  for (const double offset : {1e12, 1e14}) {
    const auto lost = run_of(egg(1, {offset, 0, offset}), {4, true});
    REQUIRE(lost->error.has_value());
    CHECK(lost->error->code == ErrorCode::bad_input);
    CAPTURE(lost->error->line());
    CHECK(lost->error->message.find("of the 16 digits of its coordinates") != std::string::npos);
    CHECK(lost->error->remedy.find("Move it by -(1e+1") == 0);
  }
  // Near enough the origin nothing is said.
  CHECK_FALSE(warned_of(*run_of(egg(1, {1e4, 0, 0}), {4, true})->scene, "digits"));
}

TEST_CASE("A box far along an axis has the mesh that it has at the origin") {
  for (const double offset : {1e6, -1e8, 1e8, 1e9})
    for (int axis = 0; axis < 3; ++axis) {
      CAPTURE(offset);
      CAPTURE(axis);
      Vec3 at;
      at[axis] = offset;
      TriangleSoup box;
      testing::add_box(box, at, at + Vec3{1, 1, 1});
      const auto run = run_of(box, {6, true});
      REQUIRE_MESSAGE(run->result.has_value(), (run->error ? run->error->line() : ""));
      CHECK_FALSE(run->result->failure.has_value());
      CHECK(run->result->certificate.holds());
      CHECK(run->result->exit_status() == 0);
      CHECK(run->result->mesh.points.size() <= 12);
    }
}

TEST_CASE("The grid of points leaves room for their midpoints, and is 2^-40 of the size near the origin") {
  const auto around = [](double x) { return Box3{{x - 1, -1, -1}, {x + 1, 1, 1}}; };
  for (const double x : {0.0, 10.0, 1000.0}) CHECK(snap_unit(1, around(x)) == std::ldexp(1.0, -40));
  for (const double x : {1e4, 1e8, -3e12}) {
    const double unit = snap_unit(1, around(x)), a = unit * std::round(x / unit), b = a + unit;
    CHECK(a < 0.5 * (a + b));
    CHECK(0.5 * (a + b) < b);
  }
}

TEST_CASE("A run that has to end before its last stage is no success, and says why in its report") {
  auto run = run_of(egg(1), {8, true});
  REQUIRE(run->result.has_value());
  CHECK(run->result->exit_status() == 0);
  run->result->failure = Error{ErrorCode::unsupported, "The digits do not suffice.", ""};
  CHECK(run->result->exit_status() == 1);
  CHECK(report_json(run->parameters, *run->scene, *run->result, {}).find("The digits do not suffice.") !=
        std::string::npos);
}

TEST_CASE("Digits are counted where the model lies") {
  CHECK(coordinate_digits(egg(1)).left >= 15);
  const CoordinateDigits far = coordinate_digits(egg(1, {1e12, 0, 0}));
  CHECK(far.left == 4);
  CHECK(far.step == std::ldexp(1.0, -13));
  CHECK(far.distance_ratio == doctest::Approx(5e11));
  CHECK(coordinate_digits(egg(1e-58)).left >= 15);
}
