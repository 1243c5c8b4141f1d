// One run of isoscope-run: what it is told, and its row.
#pragma once

#include "sweep/child_run.h"
#include "sweep/run_table.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isoscope::sweep {

/// What one run needs.
struct RunCall {
  std::filesystem::path program;    ///< isoscope-run
  std::string model;                ///< a file, or gallery:NAME
  std::vector<std::string> options; ///< for the program, beside tolerance and files
  std::filesystem::path mesh;       ///< where the result goes; empty: nowhere
  std::filesystem::path report;     ///< a file that is there only meanwhile
};

/// Runs it and measures; nothing where the control was cancelled before it ended.
std::optional<Row> run_one(const RunCall& call, const Asked& asked, const Limits& limits,
                           const RunControl& control);

} // namespace isoscope::sweep
