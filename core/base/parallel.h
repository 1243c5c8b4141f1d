// Parallel computation with results in a defined order, so that any number of threads gives the same run.
// The only door to oneTBB.
#pragma once

#include "base/run_control.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>

namespace isoscope {

/// Runs body(begin, end) over disjoint ranges that cover [0, n), each about `grain` long, in parallel.
/// The body may write only to places owned by its own indices: then the result does not depend on the
/// threads.
void parallel_ranges(std::size_t n, std::size_t grain,
                     const std::function<void(std::size_t, std::size_t)>& body);

/// Runs body(i) for every i in [0, n). Sequential below `grain` items.
template <class Body> void parallel_for(std::size_t n, std::size_t grain, Body&& body) {
  if (n <= grain) {
    for (std::size_t i = 0; i < n; ++i) body(i);
    return;
  }
  parallel_ranges(n, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

/// The same, and asks stop() before each item, or every few where `grain` allows: once it is true the rest is
/// left out. False when something was left out; which items were done is then chance.
template <class Stop, class Body>
bool parallel_until(std::size_t n, std::size_t grain, const Stop& stop, Body&& body) {
  const std::size_t items_by_question = std::clamp<std::size_t>(grain, 1, 8);
  std::atomic<bool> stopped{false};
  const auto work = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if ((i - begin) % items_by_question == 0 && (stopped.load(std::memory_order_relaxed) || stop()))
        return stopped.store(true, std::memory_order_relaxed);
      body(i);
    }
  };
  if (n <= grain)
    work(0, n);
  else
    parallel_ranges(n, grain, work);
  return !stopped.load(std::memory_order_relaxed);
}

/// The same until the control is cancelled.
template <class Body>
bool parallel_until(std::size_t n, std::size_t grain, const RunControl& control, Body&& body) {
  return parallel_until(
      n, grain, [&] { return control.cancelled(); }, body);
}

/// Limits the number of threads used by this process while it lives. 0 means all cores.
class ThreadLimit {
 public:
  explicit ThreadLimit(unsigned threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Cores this process may use, at least 1.
unsigned hardware_threads();

} // namespace isoscope
