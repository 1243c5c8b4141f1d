// Options by CLI11, values judged by parameters.h.
#include "cli/options.h"

#include "base/field_options.h"
#include "input/gallery.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <optional>

namespace isoscope {

struct RunOptions::Raw {
  RunParameters parameters;
  std::optional<Error> wrong; ///< the first value that a field cannot have
  bool no_normals = false;
  std::string outside;
  std::string record;
  std::vector<std::string> breakpoints;
  const CLI::App* app = nullptr; ///< on which they are registered
};

namespace {

/// An option whose text is several arguments.
void add_option_of_words(CLI::App& app, const FieldOption& option,
                         const std::function<void(const std::string&)>& take) {
  app.add_option_function<std::vector<std::string>>(
         option.name,
         [=](const std::vector<std::string>& words) {
           std::string text;
           for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
           take(text);
         },
         option.help)
      ->expected(option.values);
}

} // namespace

void add_field_options(CLI::App& app, const std::vector<FieldOption>& options, std::optional<Error>& wrong) {
  const auto judge = [&wrong](const Status& status) {
    if (!wrong && !status) wrong = status.error();
  };
  for (const FieldOption& option : options)
    std::visit(
        [&]<class T>(const std::function<Status(const T&)>& take) {
          if constexpr (std::is_same_v<T, bool>)
            app.add_flag_function(
                option.name, [=](std::int64_t given) { judge(take(given > 0)); }, option.help);
          else if constexpr (std::is_arithmetic_v<T>)
            // An empty value is none: check_values() says so.
            app.add_option_function<std::optional<T>>(
                option.name,
                [=](const std::optional<T>& value) {
                  if (value) judge(take(*value));
                },
                option.help);
          else if (std::is_same_v<T, std::string> && option.values > 1)
            add_option_of_words(app, option, [=](const std::string& text) {
              if constexpr (std::is_same_v<T, std::string>) judge(take(text));
            });
          else
            app.add_option_function<T>(
                option.name, [=](const T& value) { judge(take(value)); }, option.help);
        },
        option.take);
}

RunOptions::RunOptions(CLI::App& app, bool input_required) : raw_(std::make_unique<Raw>()) {
  Raw& r = *raw_;
  r.app = &app;
  add_field_options(app, field_options(r.parameters), r.wrong);
  if (input_required) app.get_option("INPUT")->required();
  app.add_option("--outside", r.outside,
                 "the outer surface, a mesh file, where --inside gives the inner one");
  app.add_flag("--no-normals", r.no_normals, "the same as --no-condition 3");
  app.add_option("--record", r.record,
                 "keep the run, event by event, in a file RUN.isorun; it can be opened while it grows");
  app.add_option("--break", r.breakpoints,
                 "stop at the first event for which a condition holds, such as "
                 "'reject && reason == kernel_empty'; repeatable, each stops");
}

RunOptions::~RunOptions() = default;

const std::string& RunOptions::recording() const {
  return raw_->record;
}

Result<RunParameters> RunOptions::finish() const {
  const Raw& r = *raw_;
  if (Status whole = check_values(*r.app); !whole) return whole.error();
  if (r.wrong) return *r.wrong;
  RunParameters p = r.parameters;
  const auto given = [&](const char* option) { return r.app->count(option) > 0; };
  if (given("--outside") != given("--inside"))
    return Error{ErrorCode::usage,
                 std::string(given("--outside") ? "--inside" : "--outside") +
                     " is missing: a volume has two walls.",
                 "Give --inside INNER --outside OUTER."};
  if (given("--outside") && given("INPUT"))
    return Error{ErrorCode::usage, "INPUT is given, and a volume by --inside and --outside.",
                 "Give one of both."};
  if (given("--outside")) p.input = r.outside;
  if (given("--tolerance") && (given("--inside") || given("--levels") || given("--label")))
    return Error{ErrorCode::usage, "--tolerance is given where the volume itself is: it tells δ.",
                 "Leave --tolerance out."};
  if (const GalleryEntry* entry = gallery_entry(p.input)) {
    if (entry->gives_volume() && given("--tolerance"))
      return Error{ErrorCode::usage, "--tolerance is given where the volume itself is: it tells δ.",
                   "Leave --tolerance out."};
    if (!entry->gives_volume() && !given("--tolerance")) p.tolerance = {entry->tolerance_percent, true};
    if (!given("--levels")) p.levels = {entry->low, entry->high};
  }
  // Half-spaces are learnt from facets that leave Ω, which sampled mode does not look at.
  if (p.containment == Containment::sampled && !given("--target")) p.target = TargetStrategy::sampling;
  if (r.no_normals) p.conditions[2] = false;
  if (Status valid = check(p); !valid) return valid.error();
  return p;
}

const std::vector<std::string>& RunOptions::breakpoints() const {
  return raw_->breakpoints;
}

Status check_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options())
    for (const std::string& value : option->results())
      if (value.empty())
        return Error{ErrorCode::usage, option->get_name() + " has an empty value.",
                     "Give one, or leave the option out."};
  return {};
}

Status add_breakpoints(const std::vector<std::string>& texts, BreakpointSet& set) {
  for (const std::string& text : texts) {
    const auto added = set.add(text);
    if (const auto* wrong = std::get_if<QueryError>(&added))
      return Error{ErrorCode::usage, "--break: " + wrong->picture(text), ""};
  }
  return {};
}

std::string gallery_table() {
  std::string table;
  for (const GalleryEntry& e : gallery()) {
    char line[512];
    char delta[16];
    std::snprintf(delta, sizeof delta, "%5.2f%%", e.tolerance_percent);
    std::snprintf(line, sizeof line, "%-23s δ %s  χ %3ld  %s\n", gallery_input(e.name).c_str(),
                  e.gives_volume() ? " given" : delta, e.euler_characteristic, std::string(e.lesson).c_str());
    table += line;
  }
  return table;
}

} // namespace isoscope
