// Options of a run that a program passes on: judged at once, kept as they were given.
#pragma once

#include "cli/command_line.h"
#include "run/parameters.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

class PassedOptions {
 public:
  /// Registers those of a run on a line, which must outlive it, but not these.
  PassedOptions(CommandLine& line, std::initializer_list<std::string_view> without);
  PassedOptions(const PassedOptions&) = delete;
  PassedOptions& operator=(const PassedOptions&) = delete;

  /// As words for isoscope-run; fails with usage on the first value that is none.
  Result<std::vector<std::string>> words() const;
  /// Of these words what they say of a run; δ and input are not among them.
  const RunParameters& parameters() const { return parameters_; }

 private:
  RunParameters parameters_;
  std::optional<Error> wrong_;
  std::vector<std::string> words_;
};

} // namespace isoscope
