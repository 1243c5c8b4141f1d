// What going on with the panel's parameters would do at the step shown, and what it would take.
#pragma once

#include "model/window_state.h"
#include "run/parameters.h"

#include <optional>
#include <string>
#include <vector>

namespace isoscope {

enum class ApplyWay : std::uint8_t {
  nothing,  ///< the run has these parameters at this step
  wrong,    ///< a value is out of its range
  restart,  ///< they belong to the whole run
  too_late, ///< no stage asks for what was changed any more
  go_on,    ///< at the live end: the run itself goes on with them
  branch    ///< another run goes on from the step shown
};
std::string_view name(ApplyWay way);

struct ApplyPlan {
  ApplyWay way = ApplyWay::nothing;
  Step step = 0; ///< from where; too_late: the last one at which all that was changed matters
  bool step_known = false;
  std::vector<LiveChange> changes;
  std::string words;          ///< one line: "Apply branches at step 120"
  std::optional<Error> error; ///< why Apply is refused, with what to do
};

/// The parameters in force at the step shown: those that the run was asked, α, σ, shrink and conditions as
/// the journal has them there.
RunParameters used_parameters(const WindowState& window);
/// What is wrong with the draft; each of its fields is asked, then how they go together.
Status check_draft(const RunParameters& draft);
ApplyPlan plan_apply(const WindowState& window);
/// What the rest of the run would take from there, by the seconds that the present one took for its stages;
/// absent while it has not come to its end, and where nothing would be done.
std::optional<Forecast> forecast(const WindowState& window, const ApplyPlan& plan);

} // namespace isoscope
