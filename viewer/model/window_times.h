// How long the window takes: for a frame, and from asking for a step until its picture is there.
#pragma once

#include "base/quantiles.h"
#include "journal/event.h"

#include <optional>
#include <string>

namespace isoscope {

/// Real seconds, whatever clock a script sees. Nothing is kept before begin().
class WindowTimes {
 public:
  /// Forgets what was measured and measures from now on.
  void begin();
  /// A frame was made, from `begun` to `done`, that shows `shown`; the play head stands at `wanted`.
  void frame(double begun, double done, std::optional<Step> shown, Step wanted);
  /// The play head stands there now.
  void stands_at(Step wanted, double now);

  const Quantiles& frames() const { return frames_; }
  const Quantiles& pictures() const { return pictures_; }
  /// Two lines: how many, median, 95 % and the largest, in milliseconds.
  std::string table() const;

 private:
  bool on_ = false;
  Quantiles frames_, pictures_;
  std::optional<Step> wanted_;
  std::optional<double> asked_at_; ///< the picture of `wanted_` is not there yet
};

} // namespace isoscope
