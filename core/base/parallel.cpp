// oneTBB behind parallel.h.
#include "base/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace isoscope {

void parallel_ranges(std::size_t n, std::size_t grain,
                     const std::function<void(std::size_t, std::size_t)>& body) {
  if (n == 0) return;
  using Range = oneapi::tbb::blocked_range<std::size_t>;
  oneapi::tbb::parallel_for(Range(0, n, std::max<std::size_t>(1, grain)),
                            [&](const Range& r) { body(r.begin(), r.end()); });
}

struct ThreadLimit::Impl {
  explicit Impl(std::size_t n) : control(oneapi::tbb::global_control::max_allowed_parallelism, n) {}
  oneapi::tbb::global_control control;
};

ThreadLimit::ThreadLimit(unsigned threads) {
  if (threads > 0) impl_ = std::make_unique<Impl>(threads);
}
ThreadLimit::~ThreadLimit() = default;

unsigned hardware_threads() {
  return static_cast<unsigned>(std::max(1, oneapi::tbb::info::default_concurrency()));
}

} // namespace isoscope
