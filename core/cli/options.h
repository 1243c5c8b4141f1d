// The command line both programs share: options to RunParameters, with later stages refused in clear words.
#pragma once

#include "base/status.h"
#include "query/breakpoints.h"
#include "run/parameters.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isoscope {

struct FieldOption;

/// Registers options of fields. After parsing, `wrong` holds the first value that a field cannot have; it
/// must outlive the parsing.
void add_field_options(CLI::App& app, const std::vector<FieldOption>& options, std::optional<Error>& wrong);

/// Registers INPUT and the options of a run on `app`. After parsing, finish() gives the parameters or says
/// which option is wrong (usage) or belongs to a later stage (unsupported, treated as usage).
class RunOptions {
 public:
  /// `input_required`: the batch program needs INPUT, the window does not.
  RunOptions(CLI::App& app, bool input_required);
  ~RunOptions();
  Result<RunParameters> finish() const;
  /// The texts of --break.
  const std::vector<std::string>& breakpoints() const;
  /// The file of --record, empty without it.
  const std::string& recording() const;

 private:
  struct Raw;
  std::unique_ptr<Raw> raw_;
};

/// Fails with usage on an option or argument whose value is empty: a name or number that a script left out.
Status check_values(const CLI::App& app);

/// Fails with usage on the first text that is no condition, with a picture of the place.
Status add_breakpoints(const std::vector<std::string>& texts, BreakpointSet& set);

/// The bundled models as a table for a terminal.
std::string gallery_table();

} // namespace isoscope
