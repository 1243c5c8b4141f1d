// The one way to cancel a long computation and to hear how far it is.
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

namespace isoscope {

/// Shared between the thread that computes and the threads that watch it. Long loops poll `cancelled()`.
class RunControl {
public:
  /// Called from the computing thread with the name of the part and its fraction done in [0, 1] (negative: unknown).
  using Progress = std::function<void(std::string_view part, double fraction)>;

  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  void reset() { cancelled_.store(false, std::memory_order_relaxed); }

  /// Set before the computation starts; not thread-safe against a running one.
  void on_progress(Progress f) { progress_ = std::move(f); }
  void report(std::string_view part, double fraction) const {
    if (progress_) progress_(part, fraction);
  }

private:
  std::atomic<bool> cancelled_{false};
  Progress progress_;
};

} // namespace isoscope
