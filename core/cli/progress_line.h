// One line on a terminal that tells how far a run is; silent where nobody watches.
#pragma once

#include "journal/recorder.h"

#include <chrono>
#include <string>
#include <string_view>

namespace isoscope {

/// Rewrites one line on standard error at most ten times a second, when that is a terminal. Used on the run's
/// thread only.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  /// A part of the preparation.
  void part(std::string_view what, double fraction);
  /// After an operation of a stage.
  void operation(const Journal& journal, Stage stage);
  /// Clears the line, so that something else can be written.
  void clear();

 private:
  bool active_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_;
  bool due();
  void draw(const std::string& text);
};

} // namespace isoscope
