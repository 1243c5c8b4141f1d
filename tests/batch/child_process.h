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

/// A run of isoscope-run whose standard error is a terminal of ours.
class TerminalRun {
 public:
  explicit TerminalRun(const std::vector<std::string>& arguments);
  ~TerminalRun();
  TerminalRun(const TerminalRun&) = delete;
  TerminalRun& operator=(const TerminalRun&) = delete;

  /// Reads until the terminal has shown `part`; false when the program ended before.
  bool read_until(const std::string& part);
  void signal(int number) const;
  /// Reads on to the end; `error` holds all that the terminal has shown.
  Ended finish();

 private:
  pid_t process_ = -1;
  int terminal_ = -1;
  std::string shown_;
  bool read_some();
};

} // namespace isoscope::test
