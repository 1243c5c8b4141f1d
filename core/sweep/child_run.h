// A program as a process of its own, under limits, measured.
#pragma once

#include "base/run_control.h"

#include <string>
#include <vector>

namespace isoscope::sweep {

struct Limits {
  double cpu_seconds = 3600; ///< of the process, after which it is killed; as it is after 20 times as long
  double memory_mib = 0;     ///< of address space; 0: no limit, as sanitizers need it
  friend bool operator==(const Limits&, const Limits&) = default;
};

/// How the process ended.
struct ChildEnd {
  int exit = 0;           ///< 128 + signal where one ended it; 127 where there is no such program
  bool timed_out = false; ///< killed by a limit of time
  bool abandoned = false; ///< killed as nobody wants it any more
  double seconds = 0;     ///< of CPU time
  double memory_mb = 0;   ///< peak
  std::string last_words; ///< the last line of standard error
};

/// Runs a program with its arguments to its end; standard output goes nowhere. It dies with this program, and
/// when the control is cancelled.
ChildEnd run_child(const std::vector<std::string>& command, const Limits& limits, const RunControl& control);

} // namespace isoscope::sweep
