// A command line: options bound to variables, read at once. The one place that knows CLI11.
#pragma once

#include "base/status.h"
#include "cli/manual_page.h"

#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isoscope {

struct FieldOption;

/// A verb with what does it, for which argv[0] is the verb. It gives the exit status.
struct Verb {
  ManualVerb told;
  int (*run)(int argc, char** argv);
};
/// Does the verb that a command line begins with, where it is one of these.
std::optional<int> run_verb(std::span<const Verb> verbs, int argc, char** argv);

class CommandLine {
 public:
  CommandLine(const std::string& about, const std::string& program);
  ~CommandLine();

  void flag(const std::string& name, bool& given, const std::string& help);
  /// "-o,--output"; a name without a hyphen is an argument by its place.
  void option(const std::string& name, std::string& value, const std::string& help, bool required = false);
  void option(const std::string& name, std::vector<std::string>& values, const std::string& help);
  void option(const std::string& name, unsigned& value, const std::string& help);
  void option(const std::string& name, double& value, const std::string& help, double low, double high);
  /// One of these words.
  void choice(const std::string& name, std::string& value, std::initializer_list<std::string> words,
              const std::string& help);
  /// Options of fields. Once it is read, `wrong` holds the first value that a field cannot have.
  void fields(const std::vector<FieldOption>& options, std::optional<Error>& wrong);
  void version(const std::string& text);
  /// What help ends with, and the manual page: verbs, then notes in paragraphs, then what the status means.
  void verb(const ManualVerb& verb);
  void notes(const std::string& text);
  void exit_status(const std::string& text);
  /// Another program that the manual page refers to.
  void see_also(const std::string& program);

  /// Reads it. A text is what was asked for instead: help, the manual page or the version.
  Result<std::optional<std::string>> read(int argc, const char* const* argv);
  /// The same for a program in a terminal, which prints it; the exit status where it ends there.
  std::optional<int> parse(int argc, const char* const* argv);
  /// Whether it was on the line that was read.
  bool given(const std::string& name) const;
  /// Fails with usage on an option or argument whose value is empty: a name or number that a script left out.
  Status check_values() const;

 private:
  struct App;
  void words(const FieldOption& option, const std::function<void(const Status&)>& judge);
  std::string footer() const;
  std::string manual() const;
  std::unique_ptr<App> app_;
};

} // namespace isoscope
