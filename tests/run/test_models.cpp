// Whole runs on real models: the right topology, certified, the same journal on any number of threads.
#include "base/parallel.h"
#include "journal/playback.h"
#include "run/complete_run.h"
#include "support/models.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// The elephant at 1 % on so many threads.
std::unique_ptr<CompleteRun> run_elephant(const std::filesystem::path& model, int effort, unsigned threads) {
  const ThreadLimit limit(threads);
  RunParameters parameters;
  parameters.input = model.string();
  parameters.tolerance = {1.0, true};
  parameters.effort = effort;
  auto run = std::make_unique<CompleteRun>(parameters);
  REQUIRE(run->run());
  CHECK(run->result->certificate.holds());
  CHECK(run->result->certificate.euler_characteristic == -4);
  return run;
}

void check_replay(const std::shared_ptr<const Journal>& journal) {
  Complex complex;
  std::vector<std::pair<Step, Complex>> states;
  for (Step k = 0; k < journal->steps(); ++k) {
    if (k % 97 == 0) states.emplace_back(k, complex);
    complex.apply(journal->operations()[k].delta());
  }
  Playback playback(journal);
  for (std::size_t i = 0; i < 2 * states.size(); ++i) {
    const auto& [step, state] = states[i * 31 % states.size()];
    playback.seek(step);
    REQUIRE(playback.complex() == state);
  }
}

} // namespace

TEST_CASE("The elephant comes out certified, with the same journal on 1 and 7 threads, and replays") {
  const auto model = demo_model("elephant.off");
  if (!model) return;
  const auto one = run_elephant(*model, 0, 1), seven = run_elephant(*model, 0, 7);
  CHECK(digest(*one->journal) == digest(*seven->journal));
  check_replay(one->journal);
}

TEST_CASE("The elephant comes out certified however hard the improver tries" * doctest::test_suite("soak")) {
  const auto model = demo_model("elephant.off");
  if (!model) return;
  const auto one = run_elephant(*model, 1, 1), seven = run_elephant(*model, 1, 7);
  CHECK(digest(*one->journal) == digest(*seven->journal));
  check_replay(run_elephant(*model, RunParameters().effort, 2)->journal);
}
