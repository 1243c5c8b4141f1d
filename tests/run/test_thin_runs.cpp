// Runs on parts thinner than 2δ: refused with a tolerance that works, left out when asked to; fins and spikes
// of thick parts are kept, and not certified where they are lost.
#include "run/complete_run.h"
#include "run/cube_with_bar.h"
#include "run/recorded_run.h"
#include "run/report.h"
#include "tolerance/shapes.h"

#include <nlohmann/json.hpp>

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::test;
using namespace isoscope::testing;

namespace {

/// A run on a soup with little effort.
struct ThinRun : CompleteRun {
  ThinRun(TriangleSoup input, double delta) : CompleteRun(std::move(input), delta) { parameters.effort = 0; }
};

/// The number after "at most " in a remedy.
double tolerance_in(const std::string& remedy) {
  return std::stod(remedy.substr(remedy.find("at most ") + 8));
}

TriangleSoup box(Vec3 lo, Vec3 hi) {
  TriangleSoup soup;
  add_box(soup, lo, hi);
  return soup;
}

} // namespace

TEST_CASE("Thin plates and needles are refused, and the tolerance that is named succeeds") {
  for (const Vec3 size : {Vec3{1, 1, 0.1}, Vec3{1, 0.1, 0.1}, Vec3{0.1, 0.1, 0.1}}) {
    CAPTURE(size.y);
    ThinRun thin(box({0, 0, 0}, size), 0.07);
    REQUIRE(!thin.run());
    REQUIRE(thin.error);
    CHECK(thin.error->code == ErrorCode::unsupported);
    CHECK(thin.error->message.find("nothing is left inside") != std::string::npos);
    const double keeps = tolerance_in(thin.error->remedy);
    CHECK(keeps > 0.04);
    CHECK(keeps < 0.05);
    ThinRun kept(box({0, 0, 0}, size), keeps);
    REQUIRE(kept.run());
    CHECK(kept.result->exit_status() == 0);
    CHECK(kept.result->certificate.covers);
  }
}

TEST_CASE("A thin part beside a thick one is refused, or left out and reported") {
  TriangleSoup soup = box({0, 0, 0}, {1, 1, 1});
  add_box(soup, {2, 0, 0}, {3, 1, 0.1});
  ThinRun refused(soup, 0.06);
  REQUIRE(!refused.run());
  CHECK(refused.error->remedy.find("--drop-thin") != std::string::npos);

  ThinRun dropped(soup, 0.06);
  dropped.parameters.drop_thin = true;
  REQUIRE(dropped.run());
  CHECK(dropped.result->exit_status() == 0);
  CHECK(dropped.result->certificate.components == 1);
  CHECK(dropped.result->certificate.topology_as_expected());
  REQUIRE(dropped.scene->left_out.size() == 1);
  CHECK(dropped.scene->left_out[0].box.hi.x == 3);
  CHECK(dropped.scene->input->triangles.size() == 24);
  CHECK(dropped.scene->field->size() == 12);
  REQUIRE(!dropped.scene->warnings.empty());
  CHECK(dropped.scene->warnings.back().message.find("left out") != std::string::npos);
  const auto report = nlohmann::json::parse(
      report_json(dropped.parameters, *dropped.scene, *dropped.result, gather_statistics(*dropped.journal)));
  CHECK(report["input"]["faces"] == 24);
  REQUIRE(report["input"]["left_out"].size() == 1);
  CHECK(report["input"]["left_out"][0]["triangles"] == 12);
  CHECK(report["input"]["left_out"][0]["thickness"].get<double>() == doctest::Approx(0.1).epsilon(0.01));
  CHECK(report["parameters"]["drop_thin"] == true);
  // δ stays that of the whole input.
  ThinRun percent(soup, 0.06);
  percent.parameters.tolerance = {2, true};
  percent.parameters.drop_thin = true;
  REQUIRE(percent.prepare());
  CHECK(percent.scene->delta == doctest::Approx(0.06));
}

TEST_CASE("Of an input that is thin everywhere nothing would be left: it is refused in any case") {
  ThinRun run(box({0, 0, 0}, {1, 1, 0.05}), 0.06);
  run.parameters.drop_thin = true;
  REQUIRE(!run.run());
  CHECK(run.error->code == ErrorCode::unsupported);
  CHECK(run.error->remedy.find("--drop-thin") == std::string::npos);
}

TEST_CASE(
    "A fin or a spike thinner than twice the tolerance is kept, unless thin parts may go or nobody asks") {
  const std::array<TriangleSoup, 2> soups{cube_with_bar(0.2, 0.8, 0.49, 0.51, 1),
                                          cube_with_bar(0.49, 0.51, 0.49, 0.51, 1)};
  for (const TriangleSoup& soup : soups) {
    const auto points_asked_in = [](const ThinRun& run) {
      std::size_t n = 0;
      for (std::size_t i = 0; i < run.journal->events().size(); ++i)
        n += run.journal->events()[i].reason == Reason::thin_part ? 1 : 0;
      return n;
    };
    ThinRun kept(soup, 0.06);
    REQUIRE(kept.run());
    const Certificate& c = kept.result->certificate;
    CHECK(kept.result->exit_status() == 0);
    CHECK(c.holds());
    CHECK(c.components == 1);
    CHECK(c.euler_characteristic == 2);
    CHECK(c.input_distance.upper <= 3 * 0.06 * 1.001);
    CHECK(points_asked_in(kept) > 0);
    CHECK(kept.scene->volume->held() > 0);
    const auto report = nlohmann::json::parse(
        report_json(kept.parameters, *kept.scene, *kept.result, gather_statistics(*kept.journal)));
    CHECK(report["samples"]["held_in_thin_parts"] == kept.scene->volume->held());

    ThinRun off(soup, 0.06);
    off.parameters.cover.reset();
    REQUIRE(off.run());
    CHECK(off.result->exit_status() == 0);
    CHECK(off.result->certificate.input_distance.lower > 10 * 0.06);
    CHECK(points_asked_in(off) == 0);
    ThinRun far(soup, 0.06);
    far.parameters.cover = 30;
    REQUIRE(far.run());
    CHECK(far.result->exit_status() == 0);
    CHECK(far.scene->volume->held() == 0);
    ThinRun separate(soup, 0.06);
    separate.parameters.topology = TopologyMode::separate;
    REQUIRE(separate.run());
    CHECK(separate.result->exit_status() == 0);
    CHECK(!separate.result->certificate.cover_note.empty());
    CHECK(separate.result->certificate.uncovered.size() == 1);
  }
}

TEST_CASE("A spike that is lost, as Z may be too near for points to hold it, is told with its place") {
  ThinRun lost(cube_with_bar(0.49, 0.51, 0.49, 0.51, 1), 0.06);
  lost.parameters.cover = 1.9;
  REQUIRE(lost.run());
  const Certificate& c = lost.result->certificate;
  CHECK(lost.result->exit_status() == 1);
  CHECK(!c.covers);
  CHECK(c.topology_as_expected());
  REQUIRE(c.uncovered.size() == 1);
  CHECK(c.uncovered[0].point.x > 1.9);
  CHECK(c.uncovered[0].distance > 10 * 0.06);
  CHECK(c.uncovered[0].size > 0.6);
  const auto report = nlohmann::json::parse(
      report_json(lost.parameters, *lost.scene, *lost.result, gather_statistics(*lost.journal)));
  CHECK(report["certificate"]["covers"] == false);
  CHECK(report["certificate"]["uncovered"].size() == 1);
  CHECK(report["certificate"]["max_input_distance"].get<double>() > 0.6);
}

TEST_CASE("Ordinary shapes are covered within 3 δ, and not within a tenth") {
  CompleteRun run(complete_parameters("sphere"));
  run.parameters.effort = 0;
  REQUIRE(run.run());
  CHECK(run.result->exit_status() == 0);
  CHECK(run.result->certificate.covers);
  CompleteRun strict(complete_parameters("sphere"));
  strict.parameters.effort = 0;
  strict.parameters.cover = 0.1;
  REQUIRE(strict.run());
  CHECK(strict.result->exit_status() == 1);
  CHECK(!strict.result->certificate.uncovered.empty());
}

TEST_CASE("The scene of a recorded run whose thin parts nobody refused is rebuilt as it was") {
  RunParameters parameters;
  parameters.tolerance = {0.06, false};
  RunControl control;
  const auto scene = rebuild_scene(
      parameters, std::make_shared<const TriangleSoup>(box({0, 0, 0}, {1, 1, 0.05})), Journal(), control);
  REQUIRE(scene.ok());
  CHECK((*scene)->regions.size() == 1);
}
