// The latency bench's parts: quantiles of known times, every request asked of a small recording.
#include "bench/latency.h"

#include "input/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace isoscope;
using namespace isoscope::bench;

TEST_CASE("Quantiles are times that occurred, by each clock") {
  Distribution d("steps");
  CHECK(d.quantile(Distribution::Clock::wall, 0.5) == 0);
  for (const double seconds : {5.0, 1.0, 3.0, 2.0, 4.0}) d.add(seconds, 10 * seconds);
  CHECK(d.size() == 5);
  CHECK(d.quantile(Distribution::Clock::wall, 0.5) == 3);
  CHECK(d.quantile(Distribution::Clock::wall, 0.95) == 5);
  CHECK(d.quantile(Distribution::Clock::wall, 1) == 5);
  CHECK(d.quantile(Distribution::Clock::wall, 0.2) == 1);
  CHECK(d.quantile(Distribution::Clock::processor, 0.4) == 20);
}

TEST_CASE("Every request is asked of a recording, and the table tells of each") {
  const TemporaryFolder folder;
  const auto file = folder / "sphere.isorun";
  REQUIRE(record_run("gallery:sphere", {12, true}, file).ok());

  LatencyOptions options;
  options.repeats = 5;
  const auto rows = measure_latencies(file, options);
  REQUIRE(rows.ok());
  const auto row = [&](const std::string& what) {
    const auto found =
        std::find_if(rows->begin(), rows->end(), [&](const Distribution& d) { return d.what() == what; });
    REQUIRE(found != rows->end());
    return *found;
  };
  CHECK(row("seek, any state to any other").size() == 5);
  CHECK(row("step forward").size() == 5);
  CHECK(row("step back").size() == 5);
  CHECK(row("X-ray of an edge").size() == 5);
  CHECK(row("what-if: a target of one's own").size() == 5);
  CHECK(row("check of a whole state").size() == 1);
  const std::string text = table(*rows);
  CHECK(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) == rows->size() + 1);
}

TEST_CASE("A recording that is not there is an error") {
  CHECK(measure_latencies("/nowhere/run.isorun", {}).error().code == ErrorCode::bad_input);
}
