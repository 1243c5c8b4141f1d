// The window finds the first invalid step of a run in which one operation was falsified.
#include "support/window_script.h"

#include "recording/recording_writer.h"
#include "run/complete_run.h"
#include "run/recorded_run.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// A recording of the first `steps` operations of a refinement; operation `at` also throws the vertex that
/// was made last through its star.
std::filesystem::path planted(Step at, Step steps) {
  CompleteRun run(gallery_parameters("torus"));
  REQUIRE(run.run());
  const Journal& sound = *run.journal;
  REQUIRE(sound.steps() > steps);
  auto journal = std::make_shared<Journal>();
  for (std::size_t i = 1; i < sound.texts().size(); ++i) journal->add_text(sound.texts()[i]);
  journal->add_sample_set(sound.sample_sets()[0]);
  journal->add_parameters(sound.parameters()[0].criteria);
  Complex complex;
  for (std::size_t i = 0; journal->steps() < steps; ++i) {
    const Event& e = sound.events()[i];
    if (!e.operation) {
      journal->add_event(e);
      continue;
    }
    const Operation& operation = sound.operations()[e.step];
    Delta delta = operation.delta();
    if (e.step == at) {
      const VertexId v(complex.vertices.size() - 1);
      delta.moves.push_back({v, complex.position(v), -25 * complex.position(v)});
    }
    complex.apply(delta);
    journal->add_operation(e, delta, operation.figures);
  }
  const std::filesystem::path results = ISOSCOPE_RESULTS;
  std::filesystem::create_directories(results);
  const auto file = results / "planted.isorun";
  auto writer = RecordingWriter::create(file);
  REQUIRE(writer.ok());
  (*writer)->start(recording_header(run.parameters, run.scene->input), journal);
  REQUIRE((*writer)->finish().ok());
  return file;
}

} // namespace

TEST_CASE("the first invalid step of a falsified run is found from its end") {
  const auto file = planted(37, 60);
  CHECK(run_window("planted", R"(
wait settled
seek 37
wait settled
check
wait settled
expect check.step == 37 and check.broken == 0
seek 60
wait settled
find-invalid
wait settled
expect check.search == found and check.first_step == 38
)",
                   file.string()) == 0);
}
