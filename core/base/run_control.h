// The one way to cancel a long computation and to hear how far it is.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string_view>

namespace isoscope {

/// Shared between the thread that computes and the threads that watch it. Long loops poll `cancelled()`.
class RunControl {
 public:
  /// Called from the computing thread with the name of the part and its fraction done in [0, 1] (negative:
  /// unknown).
  using Progress = std::function<void(std::string_view part, double fraction)>;

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
  void reset() {
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
  std::atomic<bool> cancelled_{false}, abandoned_{false};
  std::atomic<std::int64_t> deadline_{0};
  Progress progress_;
};

} // namespace isoscope
