// Commands on the events of the journal: going to them, filtering them, showing their witnesses.
#include "debug/debug_actions.h"
#include "command/named_values.h"
#include "command/usage.h"

#include <algorithm>
#include <iterator>

namespace isoscope {
namespace actions {
namespace {

/// The condition that the words of a command make.
Result<std::shared_ptr<const Expression>> condition_of(const Arguments& a) {
  std::string text;
  for (const std::string& word : a) text += (text.empty() ? "" : " ") + word;
  ParsedQuery parsed = parse_query(text);
  if (const auto* error = std::get_if<QueryError>(&parsed))
    return Error{ErrorCode::usage, error->picture(text), ""};
  return std::get<std::shared_ptr<const Expression>>(std::move(parsed));
}

} // namespace
} // namespace actions

Pick pick_of(const Event& event) {
  Pick pick;
  if (event.vertex.valid() && event.other.valid()) {
    pick.kind = Pick::Kind::edge;
    pick.id = event.vertex.value;
    pick.other = event.other.value;
    pick.point = event.point;
  } else if (event.sample.valid()) {
    pick.kind = Pick::Kind::sample;
    pick.id = event.sample.value;
    pick.point = event.point;
  }
  return pick;
}

void show_event(AppModel& model, std::uint32_t index) {
  const Event& event = model.run.journal->events()[index];
  model.transport.jump(step_showing(event));
  const Pick pick = pick_of(event);
  model.selection.pick(pick);
  model.selection.event = index;
  if (pick.kind != Pick::Kind::none) model.requests.frame_selection = true;
}

namespace actions {

Status pick_operation(AppModel& model, const Arguments&) {
  const auto state = model.state();
  if (!state || state->step == 0) return Error{ErrorCode::usage, "No operation led to this step.", ""};
  const std::uint32_t index = model.run.journal->operations()[state->step - 1].event;
  const bool frame = model.requests.frame_selection;
  show_event(model, index);
  model.requests.frame_selection = frame;
  return {};
}

Status go_to_event(AppModel& model, const Arguments& a) {
  const auto number = a.size() == 1 ? parse_number(a[0]) : Result<double>(-1.0);
  if (!number || *number < 0 || *number >= static_cast<double>(model.run.journal->events().size()))
    return usage("event", "There is no such event.");
  show_event(model, static_cast<std::uint32_t>(*number));
  return {};
}

Status next_event(AppModel& model, const Arguments& a, int direction) {
  const Error none{ErrorCode::usage, "There is no such event in that direction.", ""};
  const std::ptrdiff_t here = current_event(model);
  if (a.empty()) {
    FilteredEvents& listed = model.debug.listed;
    listed.update(model.run.journal, {model.debug.filter, model.filter, model.debug.range});
    const auto& rows = listed.rows();
    const auto at = direction > 0 ? std::upper_bound(rows.begin(), rows.end(), here)
                                  : std::lower_bound(rows.begin(), rows.end(), here);
    if (direction > 0 ? at == rows.end() : at == rows.begin()) return none;
    show_event(model, direction > 0 ? *at : *std::prev(at));
    return {};
  }
  const auto expression = condition_of(a);
  if (!expression) return expression.error();
  const Direction way = direction > 0 ? Direction::forward : Direction::backward;
  // Where the journal has to be followed, the worker looks.
  if ((*expression)->needs().any()) {
    search_events(model, {*expression}, way, false);
    return {};
  }
  QuerySearch search;
  search.expressions = {*expression};
  search.from = here;
  search.direction = way;
  const auto match = find(model.run.journal, search, RunControl());
  if (!match) return none;
  show_event(model, match->event);
  return {};
}

Status go_to_stage(AppModel& model, const Arguments& a) {
  std::optional<Stage> stage;
  for (const StageWords& row : stage_table)
    if (!a.empty() && row.value != Stage::setup && is_called(row, a[0])) stage = row.value;
  if (!stage) return usage("stage", "Which stage?");
  if (const auto begin = model.index.begin_of(*stage)) {
    model.transport.jump(*begin);
    return {};
  }
  if (model.run.phase == SessionPhase::paused) {
    model.session.run_until([wanted = *stage](const Journal&, const Event& event) -> std::string {
      return event.kind == EventKind::stage_begin && event.stage == wanted ? "stage begins" : "";
    });
    model.transport.follow();
    return {};
  }
  return Error{ErrorCode::usage, "This stage has not begun.", ""};
}

Status filter_events(AppModel& model, const Arguments& a) {
  std::shared_ptr<const Expression> expression;
  if (!a.empty()) {
    const auto read = condition_of(a);
    if (!read) return read.error();
    expression = *read;
  }
  model.filter = {};
  model.debug.filter = expression;
  model.debug.filter_text = expression ? expression->text() : std::string();
  return {};
}

Status mark_witness(AppModel& model, const Arguments& a) {
  const auto xray = model.xray();
  std::optional<Vec3> found;
  if (xray) {
    const auto study = model.study();
    const CollapseAttempt& attempt = study ? study->attempt : xray->attempt;
    for (std::size_t i = 0; i < collapse_check_count && !found; ++i) {
      const auto check = static_cast<CollapseCheck>(i);
      const bool failed = attempt.check(check).state == CheckVerdict::State::failed;
      if (a.empty() ? failed : is_called(words(check), a[0])) found = witness_of(*xray, attempt, check);
    }
  }
  if (!found && a.empty())
    if (const auto event = model.selected_event()) found = model.run.journal->events()[*event].witness;
  if (!found) return Error{ErrorCode::usage, "There is no witness to show.", "Select an edge first."};
  model.selection.mark = found;
  model.requests.frame_selection = true;
  return {};
}

Status toggle_blink(AppModel& model, const Arguments&) {
  model.blinking = !model.blinking;
  if (!model.blinking) model.view.moment = Moment::both;
  return {};
}

} // namespace actions
} // namespace isoscope
