// The latency bench: how long the debugger's answers take on recordings of whole runs.
#include "bench/latency.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  using namespace isoscope;
  CLI::App app{"Opening, steps, seeks, X-rays, what-ifs and state checks on recordings, at random places: "
               "median, 95 % and the largest time.",
               "isoscope-latency"};
  std::vector<std::string> recordings;
  bench::LatencyOptions options;
  double limit = 2048;
  app.add_option("RECORDINGS", recordings, "recordings that isoscope-run --record made")->required();
  app.add_option("--repeats", options.repeats, "of each request that takes milliseconds");
  app.add_option("--seed", options.seed, "of the random places");
  app.add_option("--history-limit", limit, "of journal and keyframes together, MiB")
      ->check(CLI::Range(1.0, 1048576.0));
  CLI11_PARSE(app, argc, argv);
  options.history_limit = static_cast<std::size_t>(limit * 1048576.0);
  for (const std::string& recording : recordings) {
    const auto rows = bench::measure_latencies(recording, options);
    if (!rows) {
      std::fprintf(stderr, "isoscope-latency: %s\n", rows.error().line().c_str());
      return 2;
    }
    std::printf("%s\n%s", recording.c_str(), bench::table(*rows).c_str());
    std::fflush(stdout);
  }
  return 0;
}
