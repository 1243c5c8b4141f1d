// oneTBB behind parallel.h.
#include "base/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>

#ifdef ISOSCOPE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

#include <algorithm>

namespace isoscope {
namespace {

// Tells ThreadSanitizer, which does not see into oneTBB, that what a thread did before give() is seen after
// take().
class Handover {
 public:
#ifdef ISOSCOPE_THREAD_SANITIZER
  void give() {
    __tsan_release(this);
  }
  void take() {
    __tsan_acquire(this);
  }

 private:
  char place_ = 0;
#else
  void give() {}
  void take() {}
#endif
};

} // namespace

void parallel_ranges(std::size_t n, std::size_t grain,
                     const std::function<void(std::size_t, std::size_t)>& body) {
  if (n == 0) return;
  using Range = oneapi::tbb::blocked_range<std::size_t>;
  Handover before, after;
  before.give();
  oneapi::tbb::parallel_for(Range(0, n, std::max<std::size_t>(1, grain)), [&](const Range& r) {
    before.take();
    body(r.begin(), r.end());
    after.give();
  });
  after.take();
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
