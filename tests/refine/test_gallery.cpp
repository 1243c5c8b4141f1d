// Refinements of bundled models end with everything that a certified Z needs, the same on any number of
// threads.
#include "refine/bench.h"

#include "base/parallel.h"
#include "input/gallery.h"
#include "journal/playback.h"
#include "mesh/validity.h"

#include <doctest/doctest.h>

#include <string>

using namespace isoscope;
using namespace isoscope::testing;

TEST_CASE("bundled models are classified, contained and of the right topology") {
  for (const GalleryEntry& entry : gallery()) {
    if (entry.gives_volume() || entry.boundary_loops > 0) continue; // see tests/run/test_open_runs.cpp
    CAPTURE(std::string(entry.name));
    if (make_gallery_model(entry.name)->is_point_set()) continue; // see tests/run/test_point_runs.cpp
    BenchOptions options;
    options.percent = 1.5 * entry.tolerance_percent;
    Bench bench = Bench::gallery(entry.name, options);
    const RefinementOutcome outcome = bench.run();
    check_all(bench, outcome);
    CHECK(outcome.topology.euler_characteristic == entry.euler_characteristic);
  }
}

TEST_CASE("every thread count writes the same journal") {
  std::uint64_t expected = 0;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const ThreadLimit limit(threads);
    Bench bench = Bench::gallery("knot", {.percent = 2});
    bench.run();
    if (expected == 0) expected = digest(*bench.journal);
    CHECK(digest(*bench.journal) == expected);
  }
}

TEST_CASE("replay leads to the refiner's own triangulation, valid and Delaunay on the way") {
  Bench bench = Bench::gallery("torus", {});
  bench.run();
  Playback playback(bench.journal);
  const Step steps = bench.journal->steps();
  playback.seek(steps);
  CHECK(playback.complex() == bench.complex());
  for (Step k = steps; k > 0; k -= std::min<Step>(k, 97)) {
    playback.seek(k);
    CHECK(check_complex(playback.complex()).empty());
    CHECK(check_delaunay(playback.complex()).empty());
    const ZeroSet z = extract_zero_set(playback.complex());
    CHECK(bench.journal->operations()[k - 1].figures.zero_set_vertices == z.vertices.size());
  }
}

TEST_CASE("every insertion says which violation it answers") {
  Bench bench = Bench::gallery("sphere", {});
  bench.run();
  for (std::size_t i = 0; i < bench.journal->operations().size(); ++i) {
    const Event& event = bench.journal->events()[bench.journal->operations()[i].event];
    if (event.condition != Condition::classification) continue;
    CHECK(event.value > event.limit);
    CHECK(event.limit == doctest::Approx(0.8));
    CHECK(event.sample.valid());
    CHECK(event.point == bench.samples->positions[event.sample.index()]);
  }
}
