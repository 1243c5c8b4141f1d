// Commands on breakpoints, saved filters, ranges and steps on three levels.
#include "command/commands.h"
#include "debug/debugger.h"
#include "ui/icons.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace isoscope {
namespace {

Error wrong(const QueryError& error, const std::string& text) {
  return usage(error.picture(text));
}

Status add_breakpoint(Debugger& d, const Arguments& a) {
  const std::string text = joined(a);
  const auto added = d.breakpoints->add(text);
  if (const auto* error = std::get_if<QueryError>(&added)) return wrong(*error, text);
  return {};
}

Status toggle_break_here(Debugger& d, const Arguments& a) {
  std::string text = joined(a);
  if (text.empty())
    if (const auto suggested = suggested_breaks(d); !suggested.empty()) text = suggested.front().condition;
  if (text.empty())
    return Error{ErrorCode::usage, "Nothing is selected to break on.",
                 "Select an edge, a vertex, a tetrahedron or a sample."};
  for (const BreakpointState& b : d.breakpoints->list())
    if (b.text == text) {
      d.breakpoints->remove(b.id);
      d.window.tell("No breakpoint any more: " + text);
      return {};
    }
  const Status added = add_breakpoint(d, {text});
  if (added) d.window.tell("Breakpoint: " + text + ". F5 goes on to it, Shift+F5 back.");
  return added;
}

Status change_breakpoint(Debugger& d, const Arguments& a) {
  const auto id = whole_argument(a, 0, 1);
  if (!id || a.size() < 2) return wrong_arguments("Which breakpoint?");
  const auto number = static_cast<unsigned>(*id);
  bool found = false;
  if (a[1] == "remove" && a.size() == 2) {
    found = d.breakpoints->remove(number);
  } else if ((a[1] == "on" || a[1] == "off") && a.size() == 2) {
    found = d.breakpoints->enable(number, a[1] == "on");
  } else if (a[1] == "ignore" && a.size() == 3) {
    const auto hits = whole_argument(a, 2, 0, 1000000000);
    if (!hits) return wrong_arguments("How many hits?");
    found = d.breakpoints->ignore(number, *hits);
  } else {
    return wrong_arguments("Nothing of a breakpoint is called \"" + a[1] + "\".");
  }
  if (!found) return wrong_arguments("There is no breakpoint " + a[0] + ".");
  return {};
}

Status continue_run(Debugger& d, Direction direction) {
  auto expressions = d.breakpoints->enabled();
  if (expressions.empty() && direction == Direction::backward)
    return Error{ErrorCode::usage, "No breakpoint is enabled.", "F9 breaks on what is selected."};
  d.search(std::move(expressions), direction, true);
  return {};
}

Status save_filter(Debugger& d, const Arguments& a) {
  constexpr std::size_t most = 8;
  const std::string text = a.empty() ? d.window.filter.condition : joined(a);
  if (text.empty()) return wrong_arguments("There is no filter.");
  const ParsedQuery parsed = parse_query(text);
  if (const auto* error = std::get_if<QueryError>(&parsed)) return wrong(*error, text);
  auto& filters = d.window.settings.filters;
  if (std::find(filters.begin(), filters.end(), text) != filters.end()) return {};
  if (filters.size() == most)
    return Error{ErrorCode::usage, "There are eight saved filters already.", "Forget one of them."};
  filters.push_back(text);
  return {};
}

Status forget_filter(Debugger& d, const Arguments& a) {
  auto& filters = d.window.settings.filters;
  const auto number = whole_argument(a, 0, 1, filters.size());
  if (!number || a.size() != 1) return wrong_arguments("There is no such saved filter.");
  const auto at = static_cast<std::ptrdiff_t>(*number) - 1;
  filters.erase(filters.begin() + at);
  if (static_cast<std::size_t>(at) < d.lanes.size()) d.lanes.erase(d.lanes.begin() + at);
  return {};
}

Status choose_range(Debugger& d, const Arguments& a) {
  if (a.empty()) {
    d.window.range.reset();
    return {};
  }
  const Step live = d.window.live_step();
  const auto begin = number_argument(a, 0, 0, live), end = number_argument(a, 1, 0, 1e300);
  if (!begin || !end || *end < *begin || a.size() != 2)
    return wrong_arguments("A range has a first and a last step.");
  d.window.range =
      StepSpan{static_cast<Step>(*begin), static_cast<Step>(std::min(*end, static_cast<double>(live)))};
  return {};
}

} // namespace

void Debugger::add_commands(CommandTable& table) {
  const auto has_run = [this] { return window.has_run(); };
  add_group(
      table, {.menu = "Run", .enabled = has_run},
      {{.name = "step-over",
        .title = "Step over",
        .usage = "[N]",
        .help = "To the next attempt, gate or stage, as deep as one is: operations and edges that stay are "
                "attempts.",
        .icon = icon::right,
        .keys = {{GLFW_KEY_F10}},
        .run = [this](const Arguments& a) { return step_over(a, Direction::forward); }},
       {.name = "step-back-over",
        .title = "Step back over",
        .usage = "[N]",
        .help = "The same backwards.",
        .icon = icon::left,
        .keys = {{GLFW_KEY_F10, false, true}},
        .run = [this](const Arguments& a) { return step_over(a, Direction::backward); }},
       {.name = "step-into",
        .title = "Step into",
        .help =
            "From a stage into its operations, from an attempt into its gates or the sweeps of its repair.",
        .icon = icon::down,
        .keys = {{GLFW_KEY_F11}},
        .run = [this](const Arguments&) { return step_into(); }},
       {.name = "step-out",
        .title = "Step out",
        .help = "From a gate to its attempt, from there to the stage.",
        .icon = icon::up,
        .keys = {{GLFW_KEY_F11, false, true}},
        .run = [this](const Arguments&) { return step_out(); }},
       {.name = "continue",
        .title = "Continue to a breakpoint",
        .help = "To the next event of the journal that matches an enabled breakpoint; past its end the run "
                "goes on.",
        .icon = icon::play,
        .keys = {{GLFW_KEY_F5}},
        .run = [this](const Arguments&) { return continue_run(*this, Direction::forward); }},
       {.name = "reverse-continue",
        .title = "Back to a breakpoint",
        .help = "Back to the previous event that matches an enabled breakpoint.",
        .keys = {{GLFW_KEY_F5, false, true}},
        .run = [this](const Arguments&) { return continue_run(*this, Direction::backward); }},
       {.name = "break-here",
        .title = "Break on the selection",
        .usage = "[CONDITION]",
        .help = "A breakpoint on the selected edge with its verdict, or vertex, tetrahedron or sample, on "
                "the gate or the event shown, or on a condition; again takes it away.",
        .icon = icon::dot,
        .keys = {{GLFW_KEY_F9}},
        .run = on(*this, toggle_break_here),
        .checked =
            [this] {
              const auto suggested = suggested_breaks(*this);
              return !suggested.empty() && breaks_on(*this, suggested.front().condition);
            },
        .raw = true}});
  table.add(
      {{.name = "break",
        .title = "Add a breakpoint…",
        .usage = "CONDITION",
        .help = "Pauses the run at every event for which the condition holds.",
        .run = on(*this, add_breakpoint),
        .raw = true},
       {.name = "breakpoint",
        .title = "Change a breakpoint…",
        .usage = "ID on | off | remove, ID ignore N",
        .help = "Switches a breakpoint, takes it away, or lets its first N hits go by.",
        .run = on(*this, change_breakpoint)},
       {.name = "save-filter",
        .title = "Save the filter as a lane",
        .usage = "[CONDITION]",
        .help = "Keeps the filter of the event list, or the one given, as a lane of the timeline.",
        .run = on(*this, save_filter),
        .raw = true},
       {.name = "forget-filter",
        .title = "Forget a saved filter…",
        .usage = "NUMBER",
        .help = "Takes a lane away.",
        .run = on(*this, forget_filter)},
       {.name = "range",
        .title = "Limit to a range of steps…",
        .usage = "[FIRST LAST]",
        .help =
            "Limits lanes, plots, events, history, work and heat map to these steps; without steps to none.",
        .run = on(*this, choose_range),
        .enabled = has_run}});
}

} // namespace isoscope
