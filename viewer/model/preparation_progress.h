// One bar over all that comes before the first operation.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace isoscope {

/// What a run reports part by part, as one share of the whole that only grows, and the time that is left from
/// the time that it took so far.
class PreparationProgress {
 public:
  void begin() { *this = {}; }
  /// `part`, `fraction`: as the run reports them, negative: unknown; `seconds`: since it began.
  void report(std::string_view part, double fraction, double seconds);
  /// In [0, 1].
  double share() const { return share_; }
  double seconds() const { return seconds_; }
  /// Nothing as long as too little is done to tell.
  std::optional<double> seconds_left() const;
  /// "sampling · 12 s, about 9 s left".
  std::string words() const;

 private:
  std::string part_ = "input";
  double share_ = 0, seconds_ = 0;
  bool of_points_ = false; ///< parts were reported that only points have
};

} // namespace isoscope
