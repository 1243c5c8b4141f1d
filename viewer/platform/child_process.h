// Another program started without a shell, watched without waiting for it.
#pragma once

#include "base/status.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// The program's file on PATH, absent where there is none that can be run.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Owns the process: what still runs at the end of its life is ended.
class ChildProcess {
 public:
  /// Starts `program` with `arguments`; its input is empty, its output and errors go to `log`. Fails with io.
  static Result<ChildProcess> start(const std::filesystem::path& program,
                                    const std::vector<std::string>& arguments,
                                    const std::filesystem::path& log);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;
  ~ChildProcess();

  /// The exit status once it has ended, -1 when a signal ended it; absent while it runs.
  std::optional<int> poll();

 private:
  explicit ChildProcess(int id) : id_(id) {}
  int id_ = 0; ///< 0: nothing runs
  std::optional<int> status_;
};

} // namespace isoscope
