// The one way to cancel a long computation and to hear how far it is.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <functional>
#include <string_view>

namespace isoscope {

/// Shared between the thread that computes and the threads that watch it. Long loops poll `cancelled()`.
class RunControl {
 public:
  /// Called from the computing thread with the name of the part and its fraction done in [0, 1] (negative:
  /// unknown).
  using Progress = std::function<void(std::string_view part, double fraction)>;

  /// CPU time of the process that may go into what a stopped run still tells: its mesh and its certificate.
  static constexpr double grace_seconds = 0.2;

  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  /// Cancels, and nobody wants what is there: even the certificate of a stopped run is left out.
  void abandon() {
    abandoned_.store(true, std::memory_order_relaxed);
    cancel();
  }
  bool abandoned() const { return abandoned_.load(std::memory_order_relaxed); }
  /// From `seconds` from now on everything that polls is cancelled too; 0 takes the limit away.
  void cancel_after(double seconds) {
    deadline_.store(seconds > 0 ? now() + static_cast<std::int64_t>(seconds * 1e9) : 0,
                    std::memory_order_relaxed);
  }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed) || timed_out(); }
  /// Whether the time limit, not a person, ended it.
  bool timed_out() const {
    const std::int64_t deadline = deadline_.load(std::memory_order_relaxed);
    return deadline != 0 && now() > deadline;
  }
  /// Whether what tells of a stopped run must end as well: it was abandoned, or the grace is spent, which
  /// begins when this is asked for the first time after the stop.
  bool out_of_grace() const {
    if (!cancelled()) return false;
    if (abandoned()) return true;
    const std::int64_t cpu = cpu_time();
    std::int64_t began = 0;
    if (grace_began_.compare_exchange_strong(began, cpu, std::memory_order_relaxed)) return false;
    return cpu - began > static_cast<std::int64_t>(grace_seconds * 1e9);
  }
  void reset() {
    grace_began_.store(0, std::memory_order_relaxed);
    abandoned_.store(false, std::memory_order_relaxed);
    cancelled_.store(false, std::memory_order_relaxed);
    deadline_.store(0, std::memory_order_relaxed);
  }

  /// Set before the computation starts; not thread-safe against a running one.
  void on_progress(Progress f) { progress_ = std::move(f); }
  void report(std::string_view part, double fraction) const {
    if (progress_) progress_(part, fraction);
  }

 private:
  static std::int64_t now() {
    return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
  }
  /// Nanoseconds, never 0: what other programs do meanwhile does not count.
  static std::int64_t cpu_time() {
    std::timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1 + std::int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec;
  }
  std::atomic<bool> cancelled_{false}, abandoned_{false};
  mutable std::atomic<std::int64_t> grace_began_{0};
  std::atomic<std::int64_t> deadline_{0};
  Progress progress_;
};

/// Asks a control once in so many calls: for loops whose steps are shorter than the question.
class SparsePoll {
 public:
  explicit SparsePoll(const RunControl& control, std::uint32_t stride = 1024)
      : control_(control), stride_(stride) {}
  /// Whether the control was cancelled when last asked.
  bool cancelled() {
    if (++calls_ < stride_) return cancelled_;
    calls_ = 0;
    return cancelled_ = control_.cancelled();
  }

 private:
  const RunControl& control_;
  std::uint32_t stride_, calls_ = 0;
  bool cancelled_ = false;
};

} // namespace isoscope
