// The latency bench: how long the debugger's answers take on recordings of whole runs.
#include "bench/latency.h"

#include "support/models.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace isoscope;

int fail(const Error& error) {
  std::fprintf(stderr, "isoscope-latency: %s\n", error.line().c_str());
  return 2;
}

/// The models that have limits, each at its tolerance, recorded beside the program where they are not yet.
Result<std::vector<std::string>> recordings_of_models() {
  struct Run {
    const char* model;
    double percent;
  };
  constexpr std::array runs{Run{"turbine.off", 0.6}, Run{"elephant.off", 1}, Run{"armadillo.off", 0.9}};
  std::vector<std::string> recordings;
  for (const Run& run : runs) {
    const auto model = demo_model(run.model);
    if (!model) continue;
    const std::string file = model->stem().string() + ".isorun";
    if (!std::filesystem::exists(file)) {
      std::printf("running %s into %s\n", run.model, file.c_str());
      std::fflush(stdout);
      if (Status recorded = bench::record_run(model->string(), {run.percent, true}, file); !recorded)
        return recorded.error();
    }
    recordings.push_back(file);
  }
  return recordings;
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app{"Opening, steps, seeks, X-rays, what-ifs and state checks on recordings, at random places: "
               "median, 95 % and the largest time.",
               "isoscope-latency"};
  std::vector<std::string> recordings;
  bench::LatencyOptions options;
  double limit = 2048;
  app.add_option("RECORDINGS", recordings,
                 "recordings that isoscope-run --record made; without them turbine at 0.6 %, elephant at 1 % "
                 "and armadillo at 0.9 % are run first and recorded in the present folder");
  app.add_option("--repeats", options.repeats, "of each request that takes milliseconds");
  app.add_option("--seed", options.seed, "of the random places");
  app.add_option("--history-limit", limit, "of journal and keyframes together, MiB")
      ->check(CLI::Range(1.0, 1048576.0));
  CLI11_PARSE(app, argc, argv);
  options.history_limit = static_cast<std::size_t>(limit * 1048576.0);
  if (recordings.empty()) {
    auto made = recordings_of_models();
    if (!made) return fail(made.error());
    recordings = std::move(*made);
  }
  for (const std::string& recording : recordings) {
    const auto rows = bench::measure_latencies(recording, options);
    if (!rows) return fail(rows.error());
    std::printf("%s\n%s", recording.c_str(), bench::table(*rows).c_str());
    std::fflush(stdout);
  }
  return 0;
}
