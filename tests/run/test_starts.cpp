// Runs whose first Z is not refined: what it is, what comes out, what is refused and how it replays.
#include "base/parallel.h"
#include "criteria/nearest_sample.h"
#include "input/gallery.h"
#include "journal/describe.h"
#include "mesh/zero_set.h"
#include "questions/state_check.h"
#include "run/branch.h"
#include "run/complete_run.h"
#include "run/replay_check.h"
#include "run/statistics.h"
#include "support/models.h"

#include <doctest/doctest.h>

#include <set>
#include <utility>

using namespace isoscope;
using namespace isoscope::test;

namespace {

RunParameters from_input(const std::string& model) {
  RunParameters parameters = complete_parameters(model);
  parameters.start = FirstZ::input;
  parameters.effort = 1;
  return parameters;
}

TriangleSoup model(const char* name) {
  return *make_gallery_model(name);
}

/// What a run of this soup is refused with.
Error refusal(TriangleSoup soup, const RunParameters& parameters = from_input("sphere")) {
  CompleteRun run(parameters);
  run.soup = std::make_shared<const TriangleSoup>(std::move(soup));
  REQUIRE(!run.run());
  return *run.error;
}

/// Both, the second one moved.
TriangleSoup together(TriangleSoup a, const TriangleSoup& b, Vec3 by) {
  const auto first = static_cast<std::uint32_t>(a.points.size());
  for (const Vec3 p : b.points) a.points.push_back(p + by);
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

/// Each triangle with points of its own, every third one turned.
TriangleSoup torn(const TriangleSoup& soup) {
  TriangleSoup apart;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(apart.points.size());
    for (const Vec3 p : soup.triangle(i)) apart.points.push_back(p);
    apart.triangles.push_back({first, first + 1, first + 2});
    if (i % 3 == 0) std::swap(apart.triangles.back()[0], apart.triangles.back()[1]);
  }
  return apart;
}

/// A square plate with a square hole through its middle.
TriangleSoup plate_with_hole(double width, double height, double hole) {
  TriangleSoup plate;
  for (const double z : {0.0, height})
    for (const double half : {width / 2, hole / 2})
      for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
        plate.points.push_back({x * half, y * half, z});
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    plate.triangles.push_back({a, b, c});
    plate.triangles.push_back({a, c, d});
  };
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    quad(i, i + 4, j + 4, j);           // below
    quad(i + 8, j + 8, j + 12, i + 12); // above
    quad(i, j, j + 8, i + 8);           // around
    quad(i + 4, i + 12, j + 12, j + 4); // the hole
  }
  return plate;
}

double volume_of(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += dot(mesh.points[t[0]], cross(mesh.points[t[1]], mesh.points[t[2]])) / 6;
  return sum;
}

} // namespace

TEST_CASE("Closed models are their own first Z and come out certified, as coarse as by way of T") {
  for (const auto& [name, chi] : {std::pair("sphere", 2L), std::pair("torus", 0L),
                                  std::pair("nested-spheres", 4L), std::pair("rings", 0L)}) {
    CAPTURE(name);
    CompleteRun run(from_input(name));
    REQUIRE(run.run());
    CHECK(run.result->certificate.holds());
    CHECK(run.result->certificate.failures.empty());
    CHECK(run.result->certificate.euler_characteristic == chi);
    CHECK(run.result->form == ZeroForm::free);
    CHECK(run.result->last_stage == Stage::improve);
    const auto stages = gather_statistics(*run.journal);
    REQUIRE(stages.size() == 1);
    CHECK(stages[0].stage == Stage::improve);
    CHECK(stages[0].zero_set_vertices == run.result->mesh.points.size());
    const Event first = run.journal->events()[run.journal->operations()[0].event];
    CHECK(first.kind == EventKind::start);
    CHECK(first.count == run.scene->input->points.size());
    CHECK(describe(*run.journal, first) ==
          "1 · the first Z has " + std::to_string(first.count) + " vertices: the input itself");
    CHECK(4 * run.result->mesh.points.size() < first.count);
  }
}

TEST_CASE("The first Z is the input turned outwards, cavities inwards, whatever its triangles look like") {
  const TriangleSoup spheres = model("nested-spheres");
  CompleteRun clean(from_input("nested-spheres")), scattered(from_input("nested-spheres"));
  clean.parameters.effort = scattered.parameters.effort = 0;
  clean.soup = std::make_shared<const TriangleSoup>(spheres);
  scattered.soup = std::make_shared<const TriangleSoup>(torn(spheres));
  REQUIRE(clean.run());
  REQUIRE(scattered.run());
  const auto first = [](const CompleteRun& run) {
    Complex complex;
    complex.apply(run.journal->operations()[0].delta());
    return triangulate(extract_zero_set(complex));
  };
  const TriangleMesh z = first(clean), same = first(scattered);
  CHECK(z.points.size() == spheres.points.size());
  CHECK(z.points == same.points);
  CHECK(volume_of(z) == doctest::Approx(volume_of(same)));
  TriangleSoup outer = model("nested-spheres");
  const Box3 box = outer.bounds();
  const double side = box.longest_edge();
  CHECK(volume_of(z) > 0);
  CHECK(volume_of(z) < 0.5236 * side * side * side);
  CHECK(scattered.result->certificate.holds());
}

TEST_CASE("A run from the input is the same journal on 1, 2 and 7 threads, and replays") {
  std::set<std::uint64_t> digests;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const ThreadLimit limit(threads);
    CompleteRun run(from_input("sphere"));
    run.parameters.effort = 2;
    REQUIRE(run.run());
    digests.insert(digest(*run.journal));
    if (threads != 1) continue;
    RunControl control;
    const auto verdict = check_replay(run.parameters, run.scene->input, *run.journal, true, control);
    REQUIRE(verdict.ok());
    CAPTURE(verdict->difference);
    CHECK(verdict->same);
    CHECK(verdict->to_the_end);
  }
  CHECK(digests.size() == 1);
}

TEST_CASE("What is asked of a run without T has an answer") {
  CompleteRun run(from_input("torus"));
  REQUIRE(run.run());
  CHECK(begins_outside_of_t(*run.journal));
  for (const Step step : {Step{0}, Step{1}, run.journal->steps()}) {
    CAPTURE(step);
    CHECK(can_branch(*run.journal, step).error().code == ErrorCode::usage);
    CHECK(can_go_on(*run.journal, step).error().code == ErrorCode::usage);
    Playback playback(run.journal);
    const NearestSample nearest(run.scene->samples->positions, run.scene->samples->labels);
    const auto state = make_snapshot(playback, step, {}, &nearest);
    CHECK(state->complex.alive_tets() == 0);
    const StateReport report = check_state(*run.journal, *state, run.scene.get(), {});
    CHECK(report.broken() == 0);
    CHECK(report.valid());
    if (step == 0) continue;
    CHECK(report[Invariant::topology].state == InvariantVerdict::State::holds);
    CHECK(report[Invariant::tetrahedra].state == InvariantVerdict::State::absent);
    if (step == 1) CHECK(state->added_facets.size() == run.scene->input->triangles.size());
  }
}

TEST_CASE("Input that is no surface to begin with is refused, with the place") {
  TriangleSoup open = model("sphere");
  open.triangles.pop_back();
  Error error = refusal(open);
  CHECK(error.code == ErrorCode::usage);
  CHECK(error.message.find("it is open, it has a border at (") != std::string::npos);

  const TriangleSoup sphere = model("sphere");
  error = refusal(together(sphere, sphere, {0.5 * sphere.bounds().longest_edge(), 0, 0}));
  CHECK(error.code == ErrorCode::usage);
  CHECK(error.message.find("it meets itself, in a triangle at (") != std::string::npos);

  TriangleSoup doubled = model("sphere");
  doubled.points.push_back({0, 0, 0});
  doubled.triangles.push_back({doubled.triangles[0][0], doubled.triangles[0][1],
                               static_cast<std::uint32_t>(doubled.points.size() - 1)});
  CHECK(refusal(doubled).message.find("has 3 triangles") != std::string::npos);
}

TEST_CASE("What cannot be the first Z is refused before there is Ω") {
  const TriangleSoup sphere = model("sphere");
  CompleteRun run(from_input("sphere"));
  run.soup = std::make_shared<const TriangleSoup>(
      together(sphere, sphere, {0.5 * sphere.bounds().longest_edge(), 0, 0}));
  std::set<std::string, std::less<>> parts;
  run.control.on_progress([&](std::string_view part, double) { parts.emplace(part); });
  REQUIRE(!run.run());
  CHECK(parts.contains("input"));
  CHECK(!parts.contains("sampling"));
}

TEST_CASE("Without T few samples are drawn where nothing is thinner than twice the tolerance") {
  CompleteRun few(from_input("sphere")), many(complete_parameters("sphere"));
  REQUIRE(few.prepare());
  REQUIRE(many.prepare());
  CHECK(few.scene->default_sigma == sparsest_sigma_ratio);
  CHECK(3 * few.scene->samples->size() < many.scene->samples->size());
  CHECK(few.scene->warnings.empty());

  RunParameters asked = from_input("sphere");
  asked.sigma = 0.5;
  CompleteRun as_many(asked);
  REQUIRE(as_many.prepare());
  CHECK(as_many.scene->samples->size() == many.scene->samples->size());
}

TEST_CASE("Without T there is nothing to ask for but the improver on Z alone") {
  const auto wrong = [](const auto& edit) {
    RunParameters parameters = from_input("sphere");
    edit(parameters);
    const Status status = check(parameters);
    return status ? std::string() : status.error().message;
  };
  CHECK(wrong([](RunParameters&) {}).empty());
  CHECK(wrong([](RunParameters& p) { p.until = Stage::all; }).find("the last stage is all") !=
        std::string::npos);
  CHECK(wrong([](RunParameters& p) { p.containment = Containment::sampled; }).find("--start input") == 0);
  CHECK(wrong([](RunParameters& p) {
          p.skipped[static_cast<std::size_t>(Stage::improve)] = true;
        }).find("--skip improve") != std::string::npos);
  CHECK(wrong([](RunParameters& p) { p.improver = ImproverPlace::embedded; }).find("embedded") !=
        std::string::npos);
}

TEST_CASE("A run from the input that is stopped has a certified mesh, and goes on") {
  CompleteRun run(from_input("torus"));
  run.gate.decide = [](const Journal& journal, const Event& event) {
    return event.operation && journal.steps() == 20 ? Gate::Verdict::stop : Gate::Verdict::go_on;
  };
  REQUIRE(run.run());
  CHECK(run.result->end == RunResult::End::stopped);
  CHECK(run.result->certificate.holds());
  const std::size_t vertices = run.result->mesh.points.size();
  run.gate.decide = nullptr;
  REQUIRE(run.run());
  CHECK(run.result->end == RunResult::End::finished);
  CHECK(run.result->certificate.holds());
  CHECK(run.result->mesh.points.size() < vertices);
}

TEST_CASE("A lattice gives Z where the input is no surface, and where Ω is given") {
  for (const char* name : {"sphere", "torus", "density"}) {
    CAPTURE(name);
    CompleteRun run(from_input(name));
    run.parameters.start = FirstZ::lattice;
    run.parameters.effort = 0;
    REQUIRE(run.run());
    CHECK(run.result->certificate.failures.empty());
    CHECK(run.result->certificate.holds());
    const Event first = run.journal->events()[run.journal->operations()[0].event];
    CHECK(first.kind == EventKind::start);
    CHECK(describe(*run.journal, first).find("from a lattice of h = 0.95 δ") != std::string::npos);
  }
  // Two spheres that overlap are one surface of a lattice.
  const TriangleSoup sphere = model("sphere");
  CompleteRun run(from_input("sphere"));
  run.soup = std::make_shared<const TriangleSoup>(
      together(sphere, sphere, {0.5 * sphere.bounds().longest_edge(), 0, 0}));
  run.parameters.start = FirstZ::lattice;
  run.parameters.effort = 0;
  REQUIRE(run.run());
  CHECK(run.result->certificate.holds());
  CHECK(run.result->certificate.euler_characteristic == 2);
  CHECK(run.result->certificate.components == 1);
}

TEST_CASE("A lattice that loses a tunnel is told by its topology, and a finer one has it") {
  // A plate with a square hole of 2.4 δ.
  const double delta = 0.1;
  CompleteRun run(from_input("sphere"));
  run.soup = std::make_shared<const TriangleSoup>(plate_with_hole(24 * delta, 3 * delta, 2.4 * delta));
  run.parameters.tolerance = {delta, false};
  run.parameters.start = FirstZ::lattice;
  run.parameters.effort = 0;
  REQUIRE(run.run());
  CHECK(run.result->certificate.holds());
  CHECK(run.result->certificate.euler_characteristic == 0);
  std::size_t looks = 0;
  for (std::size_t i = 0; i < run.journal->events().size(); ++i)
    looks += run.journal->events()[i].kind == EventKind::topology_check;
  CHECK(looks >= 1);
}

TEST_CASE("Where only regions have sides a lattice is refused") {
  TriangleSoup open = model("sphere");
  open.triangles.resize(open.triangles.size() / 2);
  RunParameters parameters = from_input("sphere");
  parameters.start = FirstZ::lattice;
  CHECK(refusal(open, parameters).message.find("only regions have sides") != std::string::npos);
}

TEST_CASE("The elephant from itself: certified, and no more vertices than by way of T") {
  const auto path = demo_model("elephant.off");
  if (!path) return;
  RunParameters parameters;
  parameters.input = path->string();
  parameters.tolerance = {1.0, true};
  parameters.effort = 1;
  parameters.start = FirstZ::input;
  CompleteRun run(parameters);
  REQUIRE(run.run());
  CHECK(run.result->certificate.holds());
  CHECK(run.result->certificate.euler_characteristic == -4);
  CHECK(run.result->mesh.points.size() <= 165);
}
