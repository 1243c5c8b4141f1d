// Runs the real isoscope-run and keeps what it prints.
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace isoscope::test {

/// How a run of the program ended.
struct Ended {
  int status = -1;   ///< exit status; 128 + signal when killed by one
  std::string out;   ///< standard output
  std::string error; ///< standard error
  bool says(const std::string& part) const { return (out + error).find(part) != std::string::npos; }
};

/// Runs isoscope-run with these arguments to its end.
Ended run_batch(const std::vector<std::string>& arguments);

/// Runs a line of the shell, in which $PROGRAM is isoscope-run.
Ended run_shell(const std::string& line);

/// A run of isoscope-run whose terminal is ours: its standard error, and what hangs up on it.
class TerminalRun {
 public:
  /// Whether pseudoterminals can be opened here. Where none can, it says that the test case is skipped.
  static bool possible();
  explicit TerminalRun(const std::vector<std::string>& arguments);
  ~TerminalRun();
  TerminalRun(const TerminalRun&) = delete;
  TerminalRun& operator=(const TerminalRun&) = delete;

  /// Reads until the terminal has shown `part`; false when the program ended before.
  bool read_until(const std::string& part);
  void signal(int number) const;
  /// Closes the terminal under the program, as closing its window would, and waits for the end.
  Ended hang_up();
  /// Reads on to the end; `error` holds all that the terminal has shown.
  Ended finish();

 private:
  pid_t process_ = -1;
  int terminal_ = -1;
  std::string shown_;
  bool read_some();
};

} // namespace isoscope::test
