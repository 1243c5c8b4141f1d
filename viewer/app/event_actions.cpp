// Commands on the events of the journal: going to them, filtering them, showing their witnesses.
#include "app/command_actions.h"
#include "app/named_values.h"

#include <algorithm>

namespace isoscope::actions {
namespace {

Error usage(const std::string& name, const std::string& what) {
  return {ErrorCode::usage, what, "It is used so: " + name + " " + std::string(find_command(name)->usage)};
}

void go_to(AppModel& model, std::uint32_t index) {
  const Event& event = model.run.journal->events()[index];
  model.transport.jump(event.step + (event.operation ? 1u : 0u));
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
  model.selection.pick(pick);
  model.selection.event = index;
  if (pick.kind != Pick::Kind::none) model.requests.frame_selection = true;
}

} // namespace

Status pick_operation(AppModel& model, const Arguments&) {
  const auto state = model.state();
  if (!state || state->step == 0) return Error{ErrorCode::usage, "No operation led to this step.", ""};
  const std::uint32_t index = model.run.journal->operations()[state->step - 1].event;
  const bool frame = model.requests.frame_selection;
  go_to(model, index);
  model.requests.frame_selection = frame;
  return {};
}

Status go_to_event(AppModel& model, const Arguments& a) {
  const auto number = a.size() == 1 ? parse_number(a[0]) : Result<double>(-1.0);
  if (!number || *number < 0 || *number >= static_cast<double>(model.run.journal->events().size()))
    return usage("event", "There is no such event.");
  go_to(model, static_cast<std::uint32_t>(*number));
  return {};
}

Status next_event(AppModel& model, const Arguments& a, int direction) {
  const Journal& journal = *model.run.journal;
  EventFilter filter = a.empty() ? model.filter : EventFilter();
  for (const std::string& word : a)
    if (!filter.narrow(word)) return usage("next-event", "Nothing is called \"" + word + "\".");
  // From the selected event where it belongs to the step, else from the operation that led there.
  std::ptrdiff_t at = -1;
  const Step step = model.transport.step();
  if (step > 0 && step <= journal.steps()) at = journal.operations()[step - 1].event;
  if (model.selection.event && *model.selection.event < journal.events().size()) {
    const Event& e = journal.events()[*model.selection.event];
    if (e.step + (e.operation ? 1u : 0u) == step) at = *model.selection.event;
  }
  const auto end = static_cast<std::ptrdiff_t>(journal.events().size());
  for (at += direction; at >= 0 && at < end; at += direction)
    if (filter.passes(journal.events()[static_cast<std::size_t>(at)])) {
      go_to(model, static_cast<std::uint32_t>(at));
      return {};
    }
  return Error{ErrorCode::usage, "There is no such event in that direction.", ""};
}

Status go_to_stage(AppModel& model, const Arguments& a) {
  std::optional<Stage> stage;
  for (int i = static_cast<int>(Stage::refinement); i < stage_count && !a.empty(); ++i)
    if (name(static_cast<Stage>(i)) == a[0]) stage = static_cast<Stage>(i);
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
  EventFilter filter;
  for (const std::string& word : a)
    if (!filter.narrow(word))
      return usage("filter", "No stage, kind, condition or reason is called \"" + word + "\".");
  model.filter = filter;
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
      if (a.empty() ? failed : name(check) == a[0]) found = witness_of(*xray, attempt, check);
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

} // namespace isoscope::actions
