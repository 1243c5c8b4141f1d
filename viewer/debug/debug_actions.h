// What the debugger's commands do: breakpoints, going on and back to them, stepping on three levels.
#pragma once

#include "app/command_actions.h"

namespace isoscope {

/// Once a frame: arms the session, tells hits, takes answers, gathers lists. True when something changed.
bool update_debugger(AppModel& model);
/// Whether searches and lists are as far as the journal is.
bool debugger_is_current(const AppModel& model);

/// The event at which one stands: the selected one where it belongs to the step shown, else the operation
/// that led there; -1 before both.
std::ptrdiff_t current_event(const AppModel& model);
/// Lets the worker look for the next event; the window goes there when it has the answer.
void search_events(AppModel& model, std::vector<std::shared_ptr<const Expression>> expressions,
                   Direction direction, bool goes_on);
/// The edge or the sample that an event names; none where it names neither.
Pick pick_of(const Event& event);
/// Goes to an event, selects and frames what it names.
void show_event(AppModel& model, std::uint32_t index);
/// The gates of the event at which one stands, in their order; empty where it has none, or while the X-ray is
/// made.
std::vector<GateView> gates_of(const AppModel& model);
/// "Z, rejection 123, 4 kernel: failed, 0.2 against 1", with arrows between.
std::string breadcrumb(const AppModel& model);

namespace actions {

Status add_breakpoint(AppModel& model, const Arguments& arguments);
Status toggle_break_here(AppModel& model, const Arguments& arguments);
Status change_breakpoint(AppModel& model, const Arguments& arguments);
Status continue_run(AppModel& model, Direction direction);
Status save_filter(AppModel& model, const Arguments& arguments);
Status forget_filter(AppModel& model, const Arguments& arguments);
Status choose_range(AppModel& model, const Arguments& arguments);
Status step_over(AppModel& model, const Arguments& arguments, Direction direction);
Status step_into(AppModel& model, const Arguments& arguments);
Status step_out(AppModel& model, const Arguments& arguments);

} // namespace actions
} // namespace isoscope
