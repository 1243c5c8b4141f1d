// One line per part of a run on a terminal, rewritten in place while the part goes on.
#pragma once

#include "base/numbers.h"
#include "journal/journal.h"

#include <chrono>
#include <string>
#include <string_view>

namespace isoscope {

/// Writes to standard error and only when that is a terminal: elsewhere nothing is ever rewritten, so nothing
/// is shown. For the computing thread alone.
class ProgressLine {
 public:
  /// `wanted`: false keeps silent on a terminal too.
  explicit ProgressLine(bool wanted);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// A part and its fraction done; negative: unknown.
  void part(std::string_view name, double fraction);
  /// A stage's figures after an operation; cheap when it is too early to draw again.
  void operation(const Journal& journal, Stage stage);
  /// Ends the present line: what is printed next starts on its own.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  bool shown_;
  std::string part_;
  std::string line_;
  Clock::time_point part_began_, drawn_;
  bool due() const;
  void begin(std::string_view name);
  void draw();
};

} // namespace isoscope
