// The command line both programs share: options to RunParameters, with later stages refused in clear words.
#pragma once

#include "base/status.h"
#include "cli/command_line.h"
#include "query/breakpoints.h"
#include "run/parameters.h"

#include <memory>
#include <string>
#include <vector>

namespace isoscope {

/// Registers INPUT and the options of a run on a line, which must outlive it. After parsing, finish() gives
/// the parameters or says which option is wrong (usage) or belongs to a later stage (unsupported, treated as
/// usage).
class RunOptions {
 public:
  explicit RunOptions(CommandLine& line);
  ~RunOptions();
  Result<RunParameters> finish() const;
  /// The texts of --break.
  const std::vector<std::string>& breakpoints() const;
  /// The file of --record, empty without it.
  const std::string& recording() const;

 private:
  struct Raw;
  const CommandLine& line_;
  std::unique_ptr<Raw> raw_;
};

/// Fails with usage on the first text that is no condition, with a picture of the place.
Status add_breakpoints(const std::vector<std::string>& texts, BreakpointSet& set);

/// The bundled models as a table for a terminal.
std::string gallery_table();

} // namespace isoscope
