// Commands on breakpoints, saved filters, ranges and steps on three levels.
#include "command/command_groups.h"

#include "debug/debug_actions.h"
#include "ui/icons.h"
#include "debug/suggested_breaks.h"

#include <GLFW/glfw3.h>

namespace isoscope {

using namespace actions;
using M = AppModel;
using A = Arguments;

std::vector<Command> debug_commands() {
  const auto has_run = [](const M& m) { return m.run.journal != nullptr; };
  return {
      {"step-over",
       "Step over",
       "[N]",
       "To the next attempt, gate or stage, as deep as one is: operations and edges that stay are attempts.",
       "Run",
       icon::right,
       {{GLFW_KEY_F10}},
       [](M& m, const A& a) { return step_over(m, a, Direction::forward); },
       has_run},
      {"step-back-over",
       "Step back over",
       "[N]",
       "The same backwards.",
       "Run",
       icon::left,
       {{GLFW_KEY_F10, false, true}},
       [](M& m, const A& a) { return step_over(m, a, Direction::backward); },
       has_run},
      {"step-into",
       "Step into",
       "",
       "From a stage into its operations, from an attempt into its gates or the sweeps of its repair.",
       "Run",
       icon::down,
       {{GLFW_KEY_F11}},
       step_into,
       has_run},
      {"step-out",
       "Step out",
       "",
       "From a gate to its attempt, from there to the stage.",
       "Run",
       icon::up,
       {{GLFW_KEY_F11, false, true}},
       step_out,
       has_run},
      {"continue",
       "Continue to a breakpoint",
       "",
       "To the next event of the journal that matches an enabled breakpoint; past its end the run goes on.",
       "Run",
       icon::play,
       {{GLFW_KEY_F5}},
       [](M& m, const A&) { return continue_run(m, Direction::forward); },
       has_run},
      {"reverse-continue",
       "Back to a breakpoint",
       "",
       "Back to the previous event that matches an enabled breakpoint.",
       "Run",
       nullptr,
       {{GLFW_KEY_F5, false, true}},
       [](M& m, const A&) { return continue_run(m, Direction::backward); },
       has_run},
      {"break-here",
       "Break on the selection",
       "[CONDITION]",
       "A breakpoint on the selected edge with its verdict, or vertex, tetrahedron or sample, on the gate or "
       "the event shown, or on a condition; again takes it away.",
       "Run",
       icon::dot,
       {{GLFW_KEY_F9}},
       toggle_break_here,
       has_run,
       [](const M& m) {
         const auto suggested = suggested_breaks(m);
         return !suggested.empty() && breaks_on(m, suggested.front().condition);
       }},
      {"break",
       "Add a breakpoint…",
       "CONDITION",
       "Pauses the run at every event for which the condition holds.",
       "",
       nullptr,
       {},
       add_breakpoint},
      {"breakpoint",
       "Change a breakpoint…",
       "ID on | off | remove, ID ignore N",
       "Switches a breakpoint, takes it away, or lets its first N hits go by.",
       "",
       nullptr,
       {},
       change_breakpoint},
      {"save-filter",
       "Save the filter as a lane",
       "[CONDITION]",
       "Keeps the filter of the event list, or the one given, as a lane of the timeline.",
       "",
       nullptr,
       {},
       save_filter},
      {"forget-filter",
       "Forget a saved filter…",
       "NUMBER",
       "Takes a lane away.",
       "",
       nullptr,
       {},
       forget_filter},
      {"range",
       "Limit to a range of steps…",
       "[FIRST LAST]",
       "Limits lanes, plots, events, history, work and heat map to these steps; without steps to none.",
       "",
       nullptr,
       {},
       choose_range,
       has_run},
  };
}

} // namespace isoscope
