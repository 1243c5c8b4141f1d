// isoscope-phases INPUT [TOLERANCE [SIGMA [THREADS]]]: what each part of a run up to the refinement takes.
#include "base/parallel.h"
#include "run/passing_gate.h"
#include "run/pipeline.h"

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

using namespace isoscope;

namespace {

double seconds_of(clockid_t clock) {
  std::timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// MB in memory, now ("VmRSS:") or at most ("VmHWM:").
double megabytes(const std::string& which) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kib = 0; word == which && status >> kib) return kib * 1024e-6;
  return 0;
}

/// A line for each part, once the next one begins.
class Phases {
 public:
  void begin(const std::string& name) {
    if (name == name_) return;
    end();
    name_ = name;
    std::ofstream("/proc/self/clear_refs") << 5; // forgets the peak
    cpu_ = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    own_ = seconds_of(CLOCK_THREAD_CPUTIME_ID);
    wall_ = seconds_of(CLOCK_MONOTONIC);
  }
  void end() {
    if (name_.empty()) return;
    const double peak = megabytes("VmHWM:");
    most_ = std::max(most_, peak);
    std::printf("%-14s %8.2f %10.2f %8.2f %8.0f %8.0f\n", name_.c_str(),
                seconds_of(CLOCK_PROCESS_CPUTIME_ID) - cpu_, seconds_of(CLOCK_THREAD_CPUTIME_ID) - own_,
                seconds_of(CLOCK_MONOTONIC) - wall_, peak, megabytes("VmRSS:"));
    name_.clear();
  }
  double most() const { return most_; }

 private:
  std::string name_;
  double cpu_ = 0, own_ = 0, wall_ = 0, most_ = 0;
};

} // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("isoscope-phases INPUT [TOLERANCE [SIGMA [THREADS]]]\n", stderr);
    return 2;
  }
  RunParameters parameters;
  parameters.input = argv[1];
  if (argc > 2) {
    const auto tolerance = Tolerance::read(argv[2]);
    if (!tolerance) return 2;
    parameters.tolerance = *tolerance;
  }
  if (argc > 3) parameters.sigma = std::atof(argv[3]);
  if (argc > 4) parameters.threads = static_cast<unsigned>(std::atoi(argv[4]));
  parameters.until = Stage::refinement;

  const ThreadLimit threads(parameters.threads);
  std::printf("%-14s %8s %10s %8s %8s %8s\n", "part", "CPU s", "own CPU s", "wall s", "peak MB", "then MB");
  Phases phases;
  RunControl control;
  control.on_progress([&](std::string_view part, double) { phases.begin(std::string(part)); });
  PassingGate gate;
  auto journal = std::make_shared<Journal>();
  Pipeline pipeline(parameters, journal, gate, control);
  const auto scene = pipeline.prepare();
  if (!scene) {
    std::fprintf(stderr, "%s\n", scene.error().line().c_str());
    return 3;
  }
  phases.begin("refinement");
  const auto result = pipeline.run();
  phases.end();
  if (!result) return 3;
  const double samples = static_cast<double>((*scene)->samples->size());
  std::printf("%.0f samples, δ %.4g, %zu Z vertices, peak %.0f MB, %.0f bytes a sample, %.2f CPU s\n",
              samples, (*scene)->delta, result->size().vertices, phases.most(), phases.most() * 1e6 / samples,
              seconds_of(CLOCK_PROCESS_CPUTIME_ID));
}
