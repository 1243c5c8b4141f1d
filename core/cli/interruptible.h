// Signals that end a computation of the batch program cleanly.
#pragma once

#include "base/run_control.h"

namespace isoscope {

/// While it lives, the first SIGINT or SIGTERM and every SIGHUP cancel the control, a second SIGINT or
/// SIGTERM ends the program with status 4; writing to where nobody reads, or too much, is an error and no
/// end. One at a time.
class Interruptible {
 public:
  explicit Interruptible(RunControl& control);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
};

} // namespace isoscope
