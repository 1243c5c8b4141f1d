// Commands on the events of the journal: going to them, filtering them, showing their witnesses.
#include "debug/debugger.h"
#include "debug/lane_events.h"

#include "ui/icons.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <iterator>

namespace isoscope {
namespace {

/// The condition that the words of a command make.
Result<std::shared_ptr<const Expression>> condition_of(const Arguments& a) {
  const std::string text = joined(a);
  ParsedQuery parsed = parse_query(text);
  if (const auto* error = std::get_if<QueryError>(&parsed)) return usage(error->picture(text));
  return std::get<std::shared_ptr<const Expression>>(std::move(parsed));
}

Status pick_operation(Debugger& d, const Arguments&) {
  const auto state = d.window.state();
  if (!state || state->step == 0) return usage("No operation led to this step.");
  const std::uint32_t index = d.window.run.journal->operations()[state->step - 1].event;
  const bool frame = d.window.requests.frame_selection;
  d.show_event(index);
  d.window.requests.frame_selection = frame;
  return {};
}

Status go_to_event(Debugger& d, const Arguments& a) {
  const auto number = whole_argument(a, 0, 0);
  if (!number || a.size() != 1 || *number >= d.window.run.journal->events().size())
    return wrong_arguments("There is no such event.");
  d.show_event(static_cast<std::uint32_t>(*number));
  return {};
}

Status next_event(Debugger& d, const Arguments& a, int direction) {
  const Error none{ErrorCode::usage, "There is no such event in that direction.", ""};
  const std::ptrdiff_t here = d.current_event();
  if (a.empty()) {
    d.gather_listed();
    const auto& rows = d.listed_rows();
    if (!(d.window.event_sort == EventSort())) {
      // In another order the next one is that of the next row; from elsewhere the first.
      const auto found = std::find(rows.begin(), rows.end(), static_cast<std::uint32_t>(here));
      if (rows.empty()) return none;
      if (here < 0 || found == rows.end()) {
        d.show_event(rows.front());
        return {};
      }
      if (direction > 0 ? found + 1 == rows.end() : found == rows.begin()) return none;
      d.show_event(direction > 0 ? *(found + 1) : *(found - 1));
      return {};
    }
    const auto at = direction > 0 ? std::upper_bound(rows.begin(), rows.end(), here)
                                  : std::lower_bound(rows.begin(), rows.end(), here);
    if (direction > 0 ? at == rows.end() : at == rows.begin()) return none;
    d.show_event(direction > 0 ? *at : *std::prev(at));
    return {};
  }
  const auto expression = condition_of(a);
  if (!expression) return expression.error();
  const Direction way = direction > 0 ? Direction::forward : Direction::backward;
  // Where the journal has to be followed, the worker looks.
  if ((*expression)->needs().any()) {
    d.search({*expression}, way, false);
    return {};
  }
  QuerySearch search;
  search.expressions = {*expression};
  search.from = here;
  search.direction = way;
  const auto match = find(d.window.run.journal, search, RunControl());
  if (!match) return none;
  d.show_event(match->event);
  return {};
}

Status go_to_stage(Debugger& d, const Arguments& a) {
  std::optional<Stage> stage;
  for (const StageWords& row : stage_table)
    if (!a.empty() && row.value != Stage::setup && is_called(row, a[0])) stage = row.value;
  if (!stage) return wrong_arguments("Which stage?");
  if (const auto begin = d.window.index.begin_of(*stage)) {
    d.window.transport.jump(*begin);
    return {};
  }
  if (d.window.run.phase == SessionPhase::paused) {
    d.window.session.run_until([wanted = *stage](const Journal&, const Event& event) -> std::string {
      return event.kind == EventKind::stage_begin && event.stage == wanted ? "stage begins" : "";
    });
    d.window.transport.follow();
    return {};
  }
  return usage("This stage has not begun.");
}

Status filter_events(Debugger& d, const Arguments& a) {
  std::shared_ptr<const Expression> expression;
  if (!a.empty()) {
    const auto read = condition_of(a);
    if (!read) return read.error();
    expression = *read;
  }
  d.window.filter = {{}, expression ? expression->text() : std::string(), expression};
  return {};
}

/// The list shows one lane alone, or all again.
Status choose_lane(Debugger& d, const Arguments& a) {
  const auto lane = a.size() == 1 ? lane_filter(d, a[0]) : std::nullopt;
  if (!lane) return wrong_arguments("There is no such lane.");
  const bool off = shows_lane(d, a[0]);
  d.window.filter = {};
  if (off) return {};
  d.window.filter.chosen = lane->chosen;
  if (!lane->condition.empty()) d.window.filter.set_condition(lane->condition);
  return {};
}

Status go_to_lane_event(Debugger& d, const Arguments& a) {
  const auto step = whole_argument(a, 1, 0);
  if (a.size() != 2 || !step || !lane_filter(d, a[0]))
    return wrong_arguments("A lane and a step are needed.");
  const auto event = nearest_event(d, a[0], static_cast<Step>(*step), d.window.live_step() + 1);
  if (!event) return usage("Nothing of this lane has happened.");
  d.show_event(*event);
  return {};
}

Status sort_events(Debugger& d, const Arguments& a) {
  EventSort& sort = d.window.event_sort;
  if (a.empty()) {
    sort = {};
    return {};
  }
  const auto found = std::find(event_column_names.begin(), event_column_names.end(), a[0]);
  if (found == event_column_names.end()) return wrong_arguments("There is no column \"" + a[0] + "\".");
  const auto column = static_cast<EventColumn>(found - event_column_names.begin());
  // Numbers are asked for by the largest first; again for the other way.
  if (sort.column == column)
    sort.descending = !sort.descending;
  else
    sort = {column, column != EventColumn::step && column != EventColumn::element};
  return {};
}

Status mark_witness(Debugger& d, const Arguments& a) {
  const auto xray = d.probe.xray();
  std::optional<Vec3> found;
  if (xray) {
    const auto study = d.probe.study();
    const CollapseAttempt& attempt = study ? study->attempt : xray->attempt;
    for (std::size_t i = 0; i < collapse_check_count && !found; ++i) {
      const auto check = static_cast<CollapseCheck>(i);
      const bool failed = attempt.check(check).state == CheckVerdict::State::failed;
      if (a.empty() ? failed : is_called(words(check), joined(a))) found = witness_of(*xray, attempt, check);
    }
  }
  if (!found && a.empty())
    if (const auto event = d.window.selected_event()) found = d.window.run.journal->events()[*event].witness;
  if (!found) return Error{ErrorCode::usage, "There is no witness to show.", "Select an edge first."};
  d.window.selection.mark = found;
  d.window.requests.frame_selection = true;
  return {};
}

} // namespace

void Debugger::add_event_commands(CommandTable& table) {
  const auto has_run = [this] { return window.has_run(); };
  table.add(
      {{.name = "stage",
        .title = "Go to a stage…",
        .usage = "refinement | gamma | tessellation | rim | zero-set | all | improve",
        .help = "Goes to where a stage begins; a held run goes on until it does.",
        .run = on(*this, go_to_stage),
        .enabled = has_run},
       {.name = "next-event",
        .title = "Next event",
        .usage = "[CONDITION]",
        .help = "Goes to the next event that the list shows, or to the next for which a condition holds.",
        .menu = "Run",
        .keys = {{GLFW_KEY_DOWN}},
        .run = [this](const Arguments& a) { return next_event(*this, a, 1); },
        .enabled = has_run,
        .raw = true},
       {.name = "previous-event",
        .title = "Previous event",
        .usage = "[CONDITION]",
        .help = "The same backwards.",
        .menu = "Run",
        .keys = {{GLFW_KEY_UP}},
        .run = [this](const Arguments& a) { return next_event(*this, a, -1); },
        .enabled = has_run,
        .raw = true},
       {.name = "event",
        .title = "Go to event…",
        .usage = "NUMBER",
        .help = "Goes to an event of the journal, selects what it names and frames it.",
        .run = on(*this, go_to_event),
        .enabled = has_run},
       {.name = "lane",
        .title = "Events of one lane",
        .usage = "CONDITION | KIND | REASON | filter-N | loop-N | loops-other",
        .help = "Lists the events of one lane of the timeline alone, as classification, collapse, "
                "kernel-empty or, of an open surface, loop-3; again for all.",
        .run = on(*this, choose_lane),
        .enabled = has_run},
       {.name = "lane-event",
        .title = "Nearest event of a lane",
        .usage = "LANE STEP",
        .help = "Goes to the event of a lane that is nearest to a step, as a click on its bar does.",
        .run = on(*this, go_to_lane_event),
        .enabled = has_run},
       {.name = "sort-events",
        .title = "Sort the events",
        .usage = "[step | value | limit | ms | element]",
        .help = "Sorts the list of events by a column, the largest first; again the other way; without one "
                "by step.",
        .run = on(*this, sort_events)},
       {.name = "filter",
        .title = "Filter the events",
        .usage = "[CONDITION]",
        .help = "Lists the events for which a condition holds, or that words like +reject -kernel name; "
                "without it all.",
        .run = on(*this, filter_events),
        .raw = true}});
}

void Debugger::add_select_commands(CommandTable& table) {
  const auto has_state = [this] { return window.has_state(); };
  table.add({{.name = "pick-operation",
              .title = "Select what the operation names",
              .help = "Selects the edge or the sample of the operation shown.",
              .menu = "Select",
              .icon = icon::bolt,
              .keys = {{'E'}},
              .run = on(*this, pick_operation),
              .enabled = has_state},
             {.name = "witness",
              .title = "Show the witness",
              .usage = "[CHECK]",
              .help = "Marks the point at which the selected edge's check was decided, by default the first "
                      "that failed.",
              .menu = "Select",
              .keys = {{'J'}},
              .run = on(*this, mark_witness),
              .enabled = has_state}});
}

} // namespace isoscope
