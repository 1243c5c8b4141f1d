// Fork, a pipe for the outcome, and wait4 for the resources.
#include "bench/measure.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <sstream>

namespace isoscope::bench {

namespace {

using Clock = std::chrono::steady_clock;

std::string text_of(const Outcome& outcome) {
  return std::to_string(outcome.good ? 1 : 0) + " " + std::to_string(outcome.vertices) + " " +
         std::to_string(outcome.given) + " " + std::to_string(outcome.improving) + " " + outcome.status;
}

Outcome outcome_of(const std::string& text) {
  std::istringstream in(text);
  Outcome outcome;
  in >> outcome.good >> outcome.vertices >> outcome.given >> outcome.improving;
  in.get();
  std::getline(in, outcome.status);
  return outcome;
}

[[noreturn]] void work_in_child(const std::function<Outcome()>& work, int pipe) {
  Outcome outcome;
  try {
    outcome = work();
  } catch (const std::exception& e) {
    outcome.status = e.what();
  }
  const std::string text = text_of(outcome);
  const bool written = write(pipe, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  std::fflush(nullptr);
  _exit(written ? 0 : 1);
}

/// Reads until the other end closes; false when that took too long.
bool read_all(int pipe, Clock::time_point deadline, std::string& text) {
  std::array<char, 4096> buffer{};
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd ready{pipe, POLLIN, 0};
    const int events = poll(&ready, 1, static_cast<int>(std::clamp<long>(left, 0, 1000)));
    if (events > 0) {
      const ssize_t n = read(pipe, buffer.data(), buffer.size());
      if (n <= 0) return true;
      text.append(buffer.data(), static_cast<std::size_t>(n));
    } else if (left <= 0) {
      return false;
    }
  }
}

double seconds_of(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

} // namespace

Measured measure(const std::function<Outcome()>& work, double seconds_at_most) {
  Measured measured;
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) {
    measured.outcome.status = "no pipe";
    return measured;
  }
  std::fflush(nullptr);
  const auto began = Clock::now();
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    work_in_child(work, ends[1]);
  }
  close(ends[1]);
  std::string text;
  bool in_time = true;
  if (child > 0) {
    const std::chrono::duration<double> allowed(seconds_at_most > 0 ? seconds_at_most : 1e7);
    in_time = read_all(ends[0], began + std::chrono::duration_cast<Clock::duration>(allowed), text);
    if (!in_time) kill(child, SIGKILL);
  }
  close(ends[0]);
  int state = 0;
  rusage used{};
  if (child < 0 || wait4(child, &state, 0, &used) != child) {
    measured.outcome.status = "no process";
    return measured;
  }
  measured.seconds = std::chrono::duration<double>(Clock::now() - began).count();
  measured.cpu_seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  measured.peak_bytes = static_cast<std::size_t>(used.ru_maxrss) * 1024;
  if (!in_time) {
    measured.outcome.status = "took too long";
  } else if (WIFSIGNALED(state)) {
    measured.outcome.status = "crashed by signal " + std::to_string(WTERMSIG(state));
  } else {
    measured.outcome = outcome_of(text);
  }
  return measured;
}

} // namespace isoscope::bench
