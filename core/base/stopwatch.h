// Seconds since something began.
#pragma once

#include <chrono>

namespace isoscope {

/// The time between its making and its question.
class Stopwatch {
 public:
  /// `on`: false measures nothing and always says 0.
  explicit Stopwatch(bool on = true) : on_(on) {
    if (on) start_ = std::chrono::steady_clock::now();
  }
  double seconds() const {
    return on_ ? std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() : 0;
  }

 private:
  bool on_;
  std::chrono::steady_clock::time_point start_;
};

} // namespace isoscope
