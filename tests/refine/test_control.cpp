// Stopping, going on, and changing parameters in the middle of a refinement.
#include "refine/bench.h"

#include "journal/playback.h"
#include "mesh/validity.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

std::size_t count(const Journal& journal, EventKind kind) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < journal.events().size(); ++i) n += journal.events()[i].kind == kind ? 1u : 0u;
  return n;
}

} // namespace

TEST_CASE("a gate that stops ends the run at once, and a second run finishes it") {
  Bench bench = Bench::gallery("torus", {});
  bench.gate->script = [](const Journal& journal, const Event&) {
    return journal.steps() >= 20 ? Gate::Verdict::stop : Gate::Verdict::go_on;
  };
  const RefinementOutcome stopped = bench.run();
  CHECK(stopped.end == RefinementOutcome::End::stopped);
  CHECK(bench.journal->steps() == 20);
  CHECK_FALSE(stopped.classified);
  CHECK(check_complex(bench.complex()).empty());
  bench.gate->script = nullptr;
  check_all(bench, bench.run());
}

TEST_CASE("stopping and going on leads to the same triangulation as going through") {
  Bench whole = Bench::gallery("torus", {});
  whole.run();
  Bench halves = Bench::gallery("torus", {});
  halves.gate->script = [](const Journal& journal, const Event&) {
    return journal.steps() == 100 ? Gate::Verdict::stop : Gate::Verdict::go_on;
  };
  halves.run();
  halves.gate->script = nullptr;
  halves.run();
  CHECK(halves.complex() == whole.complex());
}

TEST_CASE("a cancelled control ends the run") {
  Bench bench = Bench::gallery("sphere", {});
  bench.control->cancel();
  CHECK(bench.run().end == RefinementOutcome::End::stopped);
}

TEST_CASE("a limit of vertices ends the run and says so") {
  BenchOptions options;
  options.limits.insertions = 40;
  Bench bench = Bench::gallery("torus", options);
  CHECK(bench.run().end == RefinementOutcome::End::limit);
  CHECK(bench.complex().vertices.size() == 40);
  CHECK(count(*bench.journal, EventKind::stopped) == 1);
}

TEST_CASE("a new margin holds from the moment it is given") {
  Bench bench = Bench::gallery("torus", {});
  bool changed = false;
  bench.gate->script = [&](const Journal& journal, const Event&) {
    if (changed || journal.steps() < 60) return Gate::Verdict::go_on;
    changed = true;
    bench.gate->wanted.alpha = 0.5;
    return Gate::Verdict::parameters_changed;
  };
  bench.criteria.alpha = 0.5;
  check_all(bench, bench.run());
  CHECK(count(*bench.journal, EventKind::parameter_change) == 1);
  CHECK(bench.journal->parameters_at(10).alpha == 0.2);
  CHECK(bench.journal->parameters_at(bench.journal->steps()).alpha == 0.5);
}

TEST_CASE("a finished run goes on under stricter parameters") {
  Bench bench = Bench::gallery("sphere", {});
  check_all(bench, bench.run());
  const Step before = bench.journal->steps();
  bench.gate->wanted.alpha = 0.6;
  bench.criteria.alpha = 0.6;
  check_all(bench, bench.run());
  CHECK(bench.journal->steps() > before);
}

TEST_CASE("denser samples take the place of the first ones") {
  Bench bench = Bench::gallery("torus", {});
  bench.run();
  auto denser = sample_boundary(*bench.volume, 0.4 * bench.criteria.delta, *bench.control);
  REQUIRE(denser.ok());
  bench.samples = std::make_shared<const BoundarySamples>(std::move(*denser));
  bench.refinement->replace_samples(bench.samples);
  bench.criteria.sigma = bench.samples->sigma;
  bench.gate->wanted.sigma = bench.samples->sigma;
  check_all(bench, bench.run());
  Playback playback(bench.journal);
  playback.seek(bench.journal->steps());
  CHECK(playback.complex() == bench.complex());
  CHECK(playback.samples() == bench.samples);
}
