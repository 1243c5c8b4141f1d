// Over CLI11, whose header is the dearest of all to read.
#include "cli/command_line.h"

#include "base/field_options.h"
#include "base/numbers.h"
#include "cli/exit_status.h"
#include "run/report.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <sstream>
#include <type_traits>

namespace isoscope {

struct CommandLine::App : CLI::App {
  using CLI::App::App;
  ManualPage told; ///< what the library has no place for
};

CommandLine::CommandLine(const std::string& about, const std::string& program)
    : app_(std::make_unique<App>(about, program)) {
  // Like the version, it is given before anything is found missing.
  app_->add_flag_callback(
      "--man", [this] { throw CLI::CallForVersion(manual(), 0); },
      "Print the manual page for man(1) and exit");
}
CommandLine::~CommandLine() = default;

void CommandLine::flag(const std::string& name, bool& given, const std::string& help) {
  app_->add_flag(name, given, help);
}

void CommandLine::option(const std::string& name, std::string& value, const std::string& help,
                         bool required) {
  app_->add_option(name, value, help)->required(required);
}

void CommandLine::option(const std::string& name, std::vector<std::string>& values, const std::string& help) {
  app_->add_option(name, values, help);
}

void CommandLine::option(const std::string& name, unsigned& value, const std::string& help) {
  app_->add_option(name, value, help);
}

void CommandLine::option(const std::string& name, double& value, const std::string& help, double low,
                         double high) {
  constexpr int digits = 9;
  const std::string range = general(low, digits) + " to " + general(high, digits);
  app_->add_option(name, value, help + "; " + range)->check(CLI::Range(low, high).description(""));
}

void CommandLine::choice(const std::string& name, std::string& value,
                         std::initializer_list<std::string> words, const std::string& help) {
  std::string offered;
  for (const std::string& word : words) offered += (offered.empty() ? "" : "|") + word;
  app_->add_option(name, value, help)
      ->check(CLI::IsMember(std::vector<std::string>(words)).description(""))
      ->type_name(offered);
}

/// An option whose text is several arguments.
void CommandLine::words(const FieldOption& option, const std::function<void(const Status&)>& judge) {
  const auto* take = std::get_if<FieldOption::Take<std::string>>(&option.take);
  app_->add_option_function<std::vector<std::string>>(
          option.name,
          [=, take = *take](const std::vector<std::string>& words) {
            std::string text;
            for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
            judge(take(text));
          },
          option.help)
      ->expected(option.values);
}

void CommandLine::fields(const std::vector<FieldOption>& options, std::optional<Error>& wrong) {
  const auto judge = [&wrong](const Status& status) {
    if (!wrong && !status) wrong = status.error();
  };
  for (const FieldOption& option : options)
    std::visit(
        [&]<class T>(const std::function<Status(const T&)>& take) {
          if constexpr (std::is_same_v<T, bool>)
            app_->add_flag_function(
                option.name, [=](std::int64_t given) { judge(take(given > 0)); }, option.help);
          else if constexpr (std::is_arithmetic_v<T>)
            // An empty value is none: check_values() says so.
            app_->add_option_function<std::optional<T>>(
                option.name,
                [=](const std::optional<T>& value) {
                  if (value) judge(take(*value));
                },
                option.help);
          else if (std::is_same_v<T, std::string> && option.values > 1)
            words(option, judge);
          else
            app_->add_option_function<T>(
                option.name, [=](const T& value) { judge(take(value)); }, option.help);
        },
        option.take);
}

void CommandLine::version(const std::string& text) {
  app_->set_version_flag("--version", text);
}

std::optional<int> run_verb(std::span<const Verb> verbs, int argc, char** argv) {
  for (const Verb& verb : verbs)
    if (argc > 1 && verb.told.name == argv[1]) return verb.run(argc - 1, argv + 1);
  return std::nullopt;
}

void CommandLine::verb(const ManualVerb& verb) {
  app_->told.verbs.push_back(verb);
}

void CommandLine::notes(const std::string& text) {
  app_->told.notes = text;
}

void CommandLine::exit_status(const std::string& text) {
  app_->told.exit_status = text;
}

void CommandLine::see_also(const std::string& program) {
  app_->told.see_also.push_back(program);
}

std::string CommandLine::footer() const {
  const ManualPage& told = app_->told;
  std::string text;
  for (const ManualVerb& v : told.verbs)
    text += app_->get_name() + " " + v.name + " " + v.arguments + " " + v.does + "; " + v.name +
            " --help tells more.\n";
  const auto add = [&](const std::string& paragraph) {
    text += (text.empty() ? "" : "\n") + paragraph + "\n";
  };
  if (!told.notes.empty()) add(told.notes);
  if (!told.exit_status.empty()) add("Exit status: " + told.exit_status);
  if (!text.empty()) text.pop_back();
  return text;
}

std::string CommandLine::manual() const {
  ManualPage page = app_->told;
  page.program = app_->get_name();
  page.version = std::string(isoscope::version());
  page.about = app_->get_description();
  page.usage = "[OPTIONS]";
  const CLI::Formatter words;
  for (const CLI::Option* option : static_cast<const App&>(*app_).get_options()) {
    const bool by_place = option->get_positional();
    std::string values = words.make_option_opts(option);
    values.erase(0, values.find_first_not_of(' '));
    (by_place ? page.arguments : page.options)
        .push_back({words.make_option_name(option, by_place), values, words.make_option_desc(option)});
    if (by_place) page.usage += " " + words.make_option_usage(option);
  }
  std::string text = page.troff();
  text.pop_back(); // the library ends the line
  return text;
}

Result<std::optional<std::string>> CommandLine::read(int argc, const char* const* argv) {
  app_->footer(footer());
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& said) {
    if (said.get_exit_code() != 0) return Error{ErrorCode::usage, said.what(), ""};
    std::ostringstream text, complaint;
    app_->exit(said, text, complaint);
    return std::optional(text.str());
  }
  return std::optional<std::string>();
}

std::optional<int> CommandLine::parse(int argc, const char* const* argv) {
  const auto asked = read(argc, argv);
  if (asked) return *asked ? std::optional(answer(**asked)) : std::nullopt;
  std::fprintf(stderr, "%s\nRun with --help for more information.\n", asked.error().message.c_str());
  return 2;
}

bool CommandLine::given(const std::string& name) const {
  return app_->count(name) > 0;
}

Status CommandLine::check_values() const {
  for (const CLI::Option* option : static_cast<const App&>(*app_).get_options())
    for (const std::string& value : option->results())
      if (value.empty())
        return Error{ErrorCode::usage, option->get_name() + " has an empty value.",
                     "Give one, or leave the option out."};
  return {};
}

} // namespace isoscope
