// Whole runs on bundled models: certified results, the same journal on any number of threads, exact replay.
//
// The golden digest pins the journal of one bundled model down to the last bit: a change of it means that the
// algorithm decides something differently. When that is meant, run this test, look at what it prints as the
// digest found, check the run's figures (insertions, χ, certificate) by eye, and put the new figure here in
// the commit that explains the change.
#include "base/parallel.h"
#include "journal/playback.h"
#include "mesh/validity.h"
#include "run/complete_run.h"
#include "run/statistics.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <set>
#include <utility>

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr std::string_view golden_model = "sphere";
constexpr std::uint64_t golden_digest = 0x8e34042d44e7770f;

} // namespace

TEST_CASE("Every bundled closed model comes out certified") {
  for (const char* name : {"sphere", "torus", "bracket", "nested-spheres", "rings"}) {
    CAPTURE(name);
    CompleteRun run(gallery_parameters(name));
    REQUIRE(run.run());
    CHECK(run.result->certificate.holds());
    CHECK(run.result->certificate.failures.empty());
    CHECK(run.result->exit_status() == 0);
    CHECK(run.result->end == RunResult::End::finished);
    CHECK(run.result->certificate.max_distance <= run.scene->delta);
    CHECK(run.result->mesh.triangles.size() > 0);
    CHECK(run.scene->samples->covering_radius <= run.parameters.criteria(run.scene->delta).sigma);
  }
}

TEST_CASE("The journal is the same bits on 1, 2 and 7 threads, and the known ones") {
  std::set<std::uint64_t> digests;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const ThreadLimit limit(threads);
    CompleteRun run(complete_parameters(std::string(golden_model)));
    REQUIRE(run.run());
    digests.insert(digest(*run.journal));
  }
  CHECK(digests.size() == 1);
  std::printf("digest of gallery:%s: 0x%016llx\n", golden_model.data(),
              static_cast<unsigned long long>(*digests.begin()));
  CHECK(*digests.begin() == golden_digest);
}

TEST_CASE("Whole runs of bundled models end coarse and certified, on Z alone") {
  for (const auto& [name, effort] :
       {std::pair("sphere", 2), std::pair("bracket", 1), std::pair("rings", 0)}) {
    CAPTURE(name);
    CompleteRun run(complete_parameters(name));
    run.parameters.effort = effort;
    REQUIRE(run.run());
    CHECK(run.result->certificate.failures.empty());
    CHECK(run.result->exit_status() == 0);
    CHECK(run.result->last_stage == Stage::improve);
    CHECK(run.result->form == ZeroForm::free);
    const auto stages = gather_statistics(*run.journal);
    REQUIRE(stages.size() == 6);
    for (std::size_t i = 1; i < stages.size(); ++i) {
      CHECK(stages[i].zero_set_vertices <= stages[i - 1].zero_set_vertices);
    }
    CHECK(run.result->mesh.points.size() == stages.back().zero_set_vertices);
    CHECK(4 * run.result->mesh.points.size() < stages.front().zero_set_vertices);
  }
}

TEST_CASE("A box in a thin volume needs few samples, and every one of them where a density is asked for") {
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {1, 0.8, 0.5});
  CompleteRun sparse(soup, 0.007);
  sparse.parameters.effort = 0;
  sparse.parameters.until = Stage::improve;
  REQUIRE(sparse.run());
  CHECK(sparse.result->certificate.holds());
  CHECK(sparse.result->mesh.points.size() == 8);
  CHECK(sparse.scene->samples->covering_radius <= 2 * sparse.scene->delta);
  CompleteRun dense(soup, 0.007);
  dense.parameters.sigma = 0.5;
  REQUIRE(dense.run());
  CHECK(dense.scene->samples->covering_radius <= 0.5 * dense.scene->delta);
  CHECK(4 * sparse.scene->samples->size() < dense.scene->samples->size());
}

TEST_CASE("Stages can be left out, and the run ends where it is told to") {
  RunParameters parameters = complete_parameters("sphere");
  parameters.until = Stage::all;
  parameters.skipped[static_cast<std::size_t>(Stage::gamma)] = true;
  CompleteRun run(parameters);
  REQUIRE(run.run());
  CHECK(run.result->certificate.holds());
  CHECK(run.result->form == ZeroForm::embedded);
  std::vector<Stage> stages;
  for (const StageStatistics& s : gather_statistics(*run.journal)) stages.push_back(s.stage);
  CHECK(stages == std::vector<Stage>{Stage::refinement, Stage::tessellation, Stage::zero_set, Stage::all});
}

TEST_CASE("A run's journal replays bit by bit from any direction to a valid triangulation") {
  CompleteRun run(gallery_parameters("torus"));
  REQUIRE(run.run());
  Complex complex;
  std::vector<Complex> states{complex};
  for (Step k = 0; k < run.journal->steps(); ++k) {
    const Delta delta = run.journal->operations()[k].delta();
    complex.apply(delta);
    states.push_back(complex);
    complex.undo(delta);
    REQUIRE(complex == states[k]);
    complex.apply(delta);
  }
  CHECK(check_complex(complex).empty());
  CHECK(check_delaunay(complex).empty());
  Playback playback(run.journal);
  std::uint64_t random = 1;
  for (int i = 0; i < 100; ++i) {
    random = random * 6364136223846793005u + 1442695040888963407u;
    const auto step = static_cast<Step>((random >> 33) % states.size());
    playback.seek(step);
    REQUIRE(playback.complex() == states[step]);
    if (i % 10 == 0)
      CHECK(check_samples(playback.complex(), playback.sample_sets(), playback.samples()->positions).empty());
  }
}

TEST_CASE("The figures after the last operation are those of the final state") {
  CompleteRun run(gallery_parameters("sphere"));
  REQUIRE(run.run());
  const Complex complex = replayed(*run.journal);
  const StepFigures& last = run.journal->operations().back().figures;
  CHECK(last.zero_set_vertices == extract_zero_set(complex).vertices.size());
  CHECK(last.zero_set_vertices == run.result->mesh.points.size());
  CHECK(last.tets == complex.alive_tets());
  CHECK(last.bad_samples == 0);
  const auto stages = gather_statistics(*run.journal);
  REQUIRE(stages.size() == 1);
  CHECK(stages[0].stage == Stage::refinement);
  CHECK(stages[0].operations == run.journal->steps());
  CHECK(stages[0].zero_set_vertices == last.zero_set_vertices);
}

TEST_CASE("Sampled mode keeps the paper's margin") {
  RunParameters parameters = gallery_parameters("sphere");
  parameters.containment = Containment::sampled;
  parameters.sigma = 0.25;
  // Condition 3 makes flat tetrahedra that condition 2, which cannot hold here, then refines for minutes.
  parameters.conditions[2] = false;
  CompleteRun run(parameters);
  REQUIRE(run.run());
  CHECK(run.scene->thresholds.boundary == run.scene->delta);
  CHECK(!run.scene->warnings.empty()); // σ = δ/4 > αδ: condition 2 cannot hold in flat places
  CHECK(run.journal->operations().back().figures.largest_error <= 1 - parameters.alpha + 1e-6);
  bool warned = false;
  for (std::size_t i = 0; i < run.journal->events().size(); ++i) {
    warned = warned || run.journal->events()[i].kind == EventKind::warning;
  }
  CHECK(warned);
}

TEST_CASE("A condition that is off asks for nothing") {
  RunParameters parameters = gallery_parameters("torus");
  parameters.conditions[2] = false;
  CompleteRun run(parameters);
  REQUIRE(run.run());
  for (const StageStatistics& stage : gather_statistics(*run.journal)) {
    CHECK(stage.insertions[static_cast<std::size_t>(Condition::orientation)] == 0);
  }
}

TEST_CASE("A run goes on from where it was under other parameters") {
  RunParameters parameters = gallery_parameters("sphere");
  CompleteRun run(parameters);
  REQUIRE(run.run());
  const Step first = run.journal->steps();
  const std::uint64_t before = digest(*run.journal);

  run.gate.wanted.alpha = 0.5;
  REQUIRE(run.run());
  CHECK(run.result->certificate.holds());
  CHECK(run.journal->steps() >= first);
  CHECK(run.journal->operations().back().figures.largest_error <= 0.5f + 1e-6f);
  CHECK(run.journal->parameters_at(run.journal->steps()).alpha == 0.5);
  CHECK(digest(*run.journal) != before);

  run.gate.wanted.sigma /= 2;
  REQUIRE(run.run());
  CHECK(run.result->certificate.holds());
  CHECK(run.journal->sample_sets().size() == 2);
  CHECK(run.journal->sample_sets()[1]->size() > run.journal->sample_sets()[0]->size());
  Playback playback(run.journal);
  playback.seek(run.journal->steps());
  CHECK(playback.samples() == run.journal->sample_sets()[1]);
  CHECK(playback.complex() == replayed(*run.journal));
}

TEST_CASE("A stopped run leaves a judged mesh behind") {
  CompleteRun run(gallery_parameters("torus"));
  run.gate.decide = [](const Journal& journal, const Event&) {
    return journal.steps() >= 60 ? Gate::Verdict::stop : Gate::Verdict::go_on;
  };
  REQUIRE(run.run());
  CHECK(run.result->end == RunResult::End::stopped);
  CHECK(run.result->exit_status() == 4);
  CHECK(run.journal->steps() < 70);
  CHECK(run.result->certificate.closed_manifold);
}

TEST_CASE("A time limit is told from a person's stop") {
  RunParameters parameters = gallery_parameters("bracket");
  parameters.tolerance = {0.2, true};
  parameters.time_limit = 1e-4;
  CompleteRun run(parameters);
  CHECK(!run.prepare());
  CHECK(run.error->code == ErrorCode::cancelled);
  CHECK(run.error->message.find("time limit") != std::string::npos);

  CompleteRun stopped(gallery_parameters("sphere"));
  stopped.control.cancel();
  CHECK(!stopped.prepare());
  CHECK(stopped.error->code == ErrorCode::cancelled);
}

TEST_CASE("What cannot be run is refused with the reason") {
  RunParameters parameters = gallery_parameters("sphere");
  parameters.input = "gallery:teapot";
  CompleteRun unknown(parameters);
  CHECK(!unknown.prepare());
  CHECK(unknown.error->code == ErrorCode::bad_input);
  CHECK(unknown.error->line().find("torus") != std::string::npos);

  parameters.input = "no such file.off";
  CompleteRun missing(parameters);
  CHECK(!missing.prepare());
  CHECK(missing.error->code == ErrorCode::bad_input);

  parameters = gallery_parameters("sphere");
  parameters.alpha = 2;
  CompleteRun wrong(parameters);
  CHECK(!wrong.prepare());
  CHECK(wrong.error->code == ErrorCode::usage);
}

TEST_CASE("A soup without triangles is refused") {
  CompleteRun run(gallery_parameters("sphere"));
  run.soup = std::make_shared<const TriangleSoup>();
  CHECK_FALSE(run.prepare());
  REQUIRE(run.error);
  CHECK(run.error->code == ErrorCode::bad_input);
}
