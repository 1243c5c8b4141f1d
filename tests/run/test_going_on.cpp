// Runs without end: to be stopped in the improver is how they end, certified; and they go on.
#include "recording/recording_reader.h"
#include "run/asymptotic_count.h"
#include "run/complete_run.h"
#include "run/recorded_run.h"
#include "run/report.h"
#include "run/session.h"
#include "run/vertex_curve.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <numbers>

#include <unistd.h>

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr double patience = 100; // seconds; only a hang reaches it

SessionSnapshot settled(const Session& session) {
  REQUIRE(session.wait_until_settled(patience));
  return session.snapshot();
}

RunParameters with_effort(int effort) {
  RunParameters parameters = complete_parameters("sphere");
  parameters.effort = effort;
  return parameters;
}

/// Speaks after so many passes of flips.
Breakpoint after_shakes(int most) {
  auto left = std::make_shared<int>(most);
  return [left](const Journal&, const Event& e) -> std::string {
    return e.kind == EventKind::shake && --*left <= 0 ? "shaken" : "";
  };
}

/// Counts the operations of a kind in the stages from `first` on.
std::size_t operations(const Journal& journal, EventKind kind, Step first = 0) {
  std::size_t n = 0;
  for (std::size_t k = first; k < journal.operations().size(); ++k)
    n += journal.events()[journal.operations()[k].event].kind == kind ? 1u : 0u;
  return n;
}

} // namespace

TEST_CASE("effort 3 goes on behind effort 2 until it is stopped, and that is its end") {
  CompleteRun two(with_effort(2));
  REQUIRE(two.run());
  CHECK_FALSE(two.result->without_end);
  CompleteRun three(with_effort(3));
  // Beyond all passes that effort 2 makes.
  const std::size_t shakes = operations(*two.journal, EventKind::shake) + 4;
  std::size_t seen = 0;
  three.gate.decide = [&](const Journal&, const Event& e) {
    seen += e.kind == EventKind::shake ? 1u : 0u;
    return seen >= shakes ? Gate::Verdict::stop : Gate::Verdict::go_on;
  };
  REQUIRE(three.run());
  const RunResult& r = *three.result;
  CHECK(r.without_end);
  CHECK(r.can_go_on);
  CHECK(r.end == RunResult::End::stopped);
  CHECK(r.certificate.holds());
  CHECK(r.exit_status() == 0);
  CHECK(r.mesh.points.size() <= two.result->mesh.points.size());
  REQUIRE(three.journal->steps() > two.journal->steps());
  // All but the end of the last stage.
  for (std::size_t i = 0; i + 1 < two.journal->events().size(); ++i)
    REQUIRE(three.journal->events()[i] == two.journal->events()[i]);
  const auto report = nlohmann::json::parse(report_json(three.parameters, *three.scene, r, {}));
  CHECK(report["without_end"] == true);
  REQUIRE(report["curve"].size() > 2);
  CHECK(report["curve"].back()["vertices"] == r.mesh.points.size());
  CHECK(report["asymptotic_optimum"]["ratio"].get<double>() > 1);
}

TEST_CASE(
    "the time limit of a run without end leaves its certificate whole; before the improver it is a stop") {
  RunParameters parameters = with_effort(3);
  parameters.time_limit = 1e-6;
  CompleteRun early(parameters);
  early.prepare();
  REQUIRE(early.error); // it never began
  CompleteRun run(with_effort(3));
  run.gate.decide = [&](const Journal&, const Event& e) {
    // As if the limit came in the midst of the improver.
    if (e.stage == Stage::improve && e.kind == EventKind::collapse) run.control.cancel_after(1e-9);
    return Gate::Verdict::go_on;
  };
  REQUIRE(run.run());
  CHECK(run.result->end == RunResult::End::limit);
  CHECK(run.result->certificate.holds());
  CHECK(run.result->exit_status() == 0);
  CompleteRun other(with_effort(2));
  other.gate.decide = [&](const Journal&, const Event& e) {
    if (e.stage == Stage::improve && e.kind == EventKind::collapse) other.control.cancel_after(1e-9);
    return Gate::Verdict::go_on;
  };
  REQUIRE(other.run());
  CHECK(other.result->exit_status() == 4);
}

TEST_CASE("a session goes on improving in the same journal, step by step, stops at once and goes on again") {
  Session session;
  CHECK_FALSE(session.go_on_improving());
  session.start(with_effort(1));
  const SessionSnapshot ended = settled(session);
  REQUIRE(ended.phase == SessionPhase::finished);
  REQUIRE(ended.result->can_go_on);
  const Step before = ended.journal->steps();
  const auto file =
      std::filesystem::temp_directory_path() / ("isoscope-going-on-" + std::to_string(getpid()) + ".isorun");
  REQUIRE(session.record(file));
  REQUIRE(session.go_on_improving());
  session.run_until(after_shakes(2));
  const SessionSnapshot held = settled(session);
  REQUIRE(held.phase == SessionPhase::paused);
  const Step at = held.journal->steps();
  CHECK(held.generation == ended.generation);
  CHECK(held.journal == ended.journal);
  CHECK(operations(*held.journal, EventKind::shake, before) == 2);
  CHECK_FALSE(session.go_on_improving()); // it does
  session.step(1);
  CHECK(settled(session).journal->steps() == at + 1);
  session.stop();
  const SessionSnapshot stopped = settled(session);
  REQUIRE(stopped.phase == SessionPhase::finished);
  CHECK(stopped.result->certificate.holds());
  CHECK(stopped.result->exit_status() == 0);
  CHECK(stopped.result->mesh.points.size() <= ended.result->mesh.points.size());
  CHECK(final_state(*stopped.journal) == replayed(*stopped.journal));
  REQUIRE(session.go_on_improving());
  session.run_until(after_shakes(1));
  REQUIRE(settled(session).phase == SessionPhase::paused);
  session.stop();
  const SessionSnapshot last = settled(session);
  REQUIRE(last.phase == SessionPhase::finished);
  CHECK(operations(*last.journal, EventKind::shake, before) >= 3);
  // The recording has all of it, and what it came to.
  session = Session();
  Session reader;
  reader.open_recording(file);
  const SessionSnapshot read = settled(reader);
  REQUIRE(read.phase == SessionPhase::finished);
  CHECK(read.journal->steps() == last.journal->steps());
  REQUIRE(read.result);
  CHECK(read.result->mesh.points == last.result->mesh.points);
  CHECK(read.result->exit_status() == 0);
  CHECK_FALSE(reader.go_on_improving());
  std::filesystem::remove(file);
}

TEST_CASE("a run that ended before the improver has nothing to go on with") {
  CompleteRun run(gallery_parameters("sphere"));
  REQUIRE(run.run());
  CHECK_FALSE(run.result->can_go_on);
  CHECK_FALSE(run.pipeline->go_on());
}

TEST_CASE("the curve has each count that differs, over seconds that run on from stage to stage") {
  CompleteRun run(with_effort(1));
  REQUIRE(run.run());
  const std::vector<CurvePoint> curve = vertex_curve(*run.journal);
  REQUIRE(curve.size() > 10);
  CHECK(run.result->curve == curve);
  CHECK(curve.back().vertices == run.result->mesh.points.size());
  CHECK(curve.back().stage == Stage::improve);
  for (std::size_t i = 1; i < curve.size(); ++i) CHECK(curve[i].seconds >= curve[i - 1].seconds);
  CHECK(vertex_curve(Journal()).empty());
}

TEST_CASE("the asymptotic count of a sphere is 2 + 1.209 r/δ, that of a torus its integral") {
  TriangleSoup sphere;
  isoscope::testing::add_sphere(sphere, {0, 0, 0}, 2, 80);
  const auto of_sphere = asymptotic_count(sphere, 2, 0.05);
  REQUIRE(of_sphere);
  CHECK(of_sphere->vertices == doctest::Approx(2 + 1.2092 * 2 / 0.05).epsilon(0.01));
  CHECK(of_sphere->hyperbolic < 0.01 * of_sphere->elliptic);
  // K = cos t / (r (R + r cos t)), dA = r (R + r cos t) dt dφ.
  const double big = 1, small = 0.4, pi = std::numbers::pi;
  TriangleSoup torus;
  isoscope::testing::add_torus(torus, {0, 0, 0}, big, small, 160);
  double outside = 0, inside = 0;
  for (int i = 0; i < 100000; ++i) {
    const double t = 2 * pi * (i + 0.5) / 100000, density = small * (big + small * std::cos(t));
    (std::cos(t) > 0 ? outside : inside) +=
        2 * pi * std::sqrt(std::abs(std::cos(t)) * density) * 2 * pi / 100000;
  }
  const auto of_torus = asymptotic_count(torus, 0, 0.01);
  REQUIRE(of_torus);
  CHECK(of_torus->elliptic == doctest::Approx(outside).epsilon(0.02));
  CHECK(of_torus->hyperbolic == doctest::Approx(inside).epsilon(0.02));
  CHECK(of_torus->vertices ==
        doctest::Approx(outside / (6 * std::sqrt(3.) * 0.01) + inside / (4 * std::sqrt(5.) * 0.01))
            .epsilon(0.02));
}

TEST_CASE("nothing is said of flat and creased surfaces, coarse ones, and triangles that share no points") {
  TriangleSoup cube;
  isoscope::testing::add_box(cube, {0, 0, 0}, {1, 1, 1});
  CHECK_FALSE(asymptotic_count(cube, 2, 0.001));
  TriangleSoup coarse;
  isoscope::testing::add_sphere(coarse, {0, 0, 0}, 1, 12);
  CHECK_FALSE(asymptotic_count(coarse, 2, 0.001));
  TriangleSoup apart;
  isoscope::testing::add_sphere(apart, {0, 0, 0}, 1, 40);
  CHECK(asymptotic_count(apart, 2, 0.05));
  CHECK_FALSE(asymptotic_count(isoscope::testing::exploded(apart, 1), 2, 0.05));
  CHECK_FALSE(asymptotic_count({}, 2, 0.05));
}
