// Runs stopped at random moments: whatever a run is doing, it obeys within half a second of CPU time, and
// what it leaves behind is sound.
//
// Moments and limits are CPU time of this process, so that neither the machine's speed nor what else it does
// decides; the stages that a stop meets differ from machine to machine, which is meant.
#include "base/parallel.h"
#include "run/complete_run.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <ctime>
#include <random>
#include <thread>

using namespace isoscope;
using namespace isoscope::test;
using namespace isoscope::testing;

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double slower = 12;
#else
constexpr double slower = 1;
#endif
constexpr double most_seconds = 0.5 * slower;

double cpu_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// An input with what makes it long, and until when it is worth stopping.
struct StopCase {
  const char* name;
  RunParameters parameters;
  std::shared_ptr<const TriangleSoup> soup; ///< instead of parameters.input, where set
  double longest;                           ///< CPU seconds
};

StopCase bundled(const char* name, double longest) {
  return {name, complete_parameters(name), nullptr, longest};
}

StopCase made(const char* name, TriangleSoup soup, double percent, double sigma, double longest) {
  RunParameters parameters;
  parameters.tolerance = {percent, true};
  parameters.sigma = sigma;
  return {name, parameters, std::make_shared<const TriangleSoup>(std::move(soup)), longest};
}

/// Many small closed parts, each a component of Ω of its own.
TriangleSoup crumbs(int n) {
  TriangleSoup soup;
  for (int i = 0; i < n * n * n; ++i) {
    const Vec3 at{10.0 * (i % n), 10.0 * (i / n % n), 10.0 * (i / (n * n))};
    add_box(soup, at, at + Vec3{3, 3, 3});
  }
  return soup;
}

/// A closed plate far thinner than δ, next to a ball.
TriangleSoup plate_and_ball() {
  TriangleSoup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1e-4});
  add_sphere(soup, {0.5, 0.5, 0.8}, 0.3, 24);
  return soup;
}

TriangleSoup ball(unsigned n) {
  TriangleSoup soup;
  add_sphere(soup, {0, 0, 0}, 1, n);
  return soup;
}

std::vector<StopCase> stop_cases() {
  std::vector<StopCase> cases;
  cases.push_back(bundled("sphere", 0.5));
  cases.push_back(bundled("bracket", 1.5));
  cases.push_back(bundled("knot", 1.5));
  cases.push_back(bundled("nested-spheres", 0.8));
  cases.push_back(made("a ball with a fine octree", ball(32), 0.2, 0, 1.2));
  cases.push_back(made("a ball with very dense samples", ball(32), 2, 0.004, 0.8));
  cases.push_back(made("a finely tessellated ball", ball(400), 2, 0, 1.2));
  cases.push_back(made("a thousand crumbs", crumbs(10), 0.5, 0, 1));
  cases.push_back(made("a plate thinner than the tolerance", plate_and_ball(), 2, 0, 0.6));
  StopCase sampled = bundled("torus", 1);
  sampled.name = "a torus in sampled mode";
  sampled.parameters.containment = Containment::sampled;
  sampled.parameters.target = TargetStrategy::sampling;
  cases.push_back(sampled);
  cases.push_back(bundled("hemisphere", 1));
  cases.push_back(bundled("bubbles", 1));
  cases.push_back(bundled("noisy-sphere", 1));
  cases.push_back(bundled("density", 1));
  cases.push_back(bundled("nested-tori", 1));
  StopCase dropping = made("a plate that is left out", plate_and_ball(), 2, 0, 1);
  dropping.parameters.drop_thin = true;
  cases.push_back(dropping);
  return cases;
}

/// One run that is told to stop once the process has used `moment` more seconds of CPU time; returns those
/// between the stop and the end, negative when the run was over before.
double stop_at(const StopCase& stopped, double moment, unsigned threads) {
  const ThreadLimit limit(threads);
  const double begin = cpu_seconds();
  std::atomic<double> told{-1};
  std::atomic<bool> over{false};
  {
    CompleteRun run(stopped.parameters);
    run.soup = stopped.soup;
    run.gate.decide = [&](const Journal&, const Event&) {
      return run.control.cancelled() ? Gate::Verdict::stop : Gate::Verdict::go_on;
    };
    std::thread hand([&] {
      while (!over && cpu_seconds() - begin < moment) usleep(500);
      if (over) return;
      told = cpu_seconds();
      run.control.cancel();
    });
    run.run();
    over = true;
    hand.join();
    if (told < 0) return -1;
    CAPTURE(stopped.name);
    CAPTURE(moment);
    // A stop that came just before the end may find the run finished; else it says what it is.
    if (run.error) CHECK(run.error->code == ErrorCode::cancelled);
    if (run.result && !run.result->certificate.holds()) CHECK_FALSE(run.result->certificate.failures.empty());
  }
  return cpu_seconds() - told;
}

/// Stops each case at so many random moments.
void check_moments(int moments) {
  std::mt19937 random(11);
  double slowest = 0;
  int met = 0, tried = 0;
  for (const StopCase& stopped : stop_cases()) {
    double worst = 0;
    for (int i = 0; i < moments; ++i) {
      const double moment =
          stopped.longest * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
      const double seconds = stop_at(stopped, moment, i % 2 == 0 ? 1 : 2);
      CAPTURE(stopped.name);
      CAPTURE(moment);
      CHECK(seconds < most_seconds);
      met += seconds >= 0 ? 1 : 0;
      ++tried;
      worst = std::max(worst, seconds);
    }
    std::printf("%-40s %.3f CPU s at most\n", stopped.name, worst);
    slowest = std::max(slowest, worst);
  }
  std::printf("%d of %d stops met a run that was not over; the slowest took %.3f CPU s\n", met, tried,
              slowest);
  CHECK(2 * met > tried);
}

} // namespace

TEST_CASE("A run obeys within half a second of CPU time at thirty-two random moments") {
  check_moments(2);
}

TEST_CASE("A run obeys within half a second of CPU time at three hundred random moments" *
          doctest::test_suite("soak")) {
  check_moments(20);
}
