// Whole runs on real models: the right topology, certified, the same journal on any number of threads.
#include "base/parallel.h"
#include "journal/playback.h"
#include "run/complete_run.h"
#include "support/models.h"

#include <doctest/doctest.h>

#include <set>

using namespace isoscope;
using namespace isoscope::test;

TEST_CASE("The elephant comes out certified, with the same journal on 1 and 7 threads, and replays") {
  const auto model = demo_model("elephant.off");
  if (!model) return;
  RunParameters parameters;
  parameters.input = model->string();
  parameters.tolerance = {1.0, true};
  // The schedule of the improver and its batches are the same at every effort; one run tries as hard as by
  // default.
  std::set<std::uint64_t> digests;
  for (const unsigned threads : {1u, 7u, 2u}) {
    const ThreadLimit limit(threads);
    parameters.effort = threads == 2 ? RunParameters().effort : 1;
    CompleteRun run(parameters);
    REQUIRE(run.run());
    CHECK(run.result->certificate.holds());
    CHECK(run.result->certificate.euler_characteristic == -4);
    if (threads != 2) {
      digests.insert(digest(*run.journal));
      continue;
    }
    Complex complex;
    std::vector<std::pair<Step, Complex>> states;
    for (Step k = 0; k < run.journal->steps(); ++k) {
      if (k % 97 == 0) states.emplace_back(k, complex);
      complex.apply(run.journal->operations()[k].delta());
    }
    Playback playback(run.journal);
    for (std::size_t i = 0; i < 2 * states.size(); ++i) {
      const auto& [step, state] = states[i * 31 % states.size()];
      playback.seek(step);
      REQUIRE(playback.complex() == state);
    }
  }
  CHECK(digests.size() == 1);
}
