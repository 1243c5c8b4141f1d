// Runs a piece of work in a process of its own: its time, its memory, and no harm when it crashes.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace isoscope::bench {

/// What a piece of work has to say.
struct Outcome {
  bool good = false;        ///< the result counts
  std::size_t vertices = 0; ///< of the result
  std::string status;       ///< in a few words
  std::size_t given = 0;    ///< vertices of the input
  double improving = 0;     ///< seconds on the wall of the improver
};

/// An outcome with what it took.
struct Measured {
  Outcome outcome;
  double seconds = 0;     ///< on the wall
  double cpu_seconds = 0; ///< of all threads
  std::size_t peak_bytes = 0;
};

/// Runs the work in a child process and waits for it; ends it after `seconds_at_most` (0: never). A crash or
/// an exception is an outcome that is not good. The calling process must not have started threads.
Measured measure(const std::function<Outcome()>& work, double seconds_at_most);

} // namespace isoscope::bench
