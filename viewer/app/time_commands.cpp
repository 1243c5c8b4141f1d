// What scripts measure of the window itself.
#include "command/command_groups.h"

#include <cstdio>

namespace isoscope {

namespace {

Status tell_times(AppModel& model, const Arguments& a) {
  if (a.size() == 1 && a[0] == "reset") {
    model.times.begin();
    return {};
  }
  if (!a.empty()) return Error{ErrorCode::usage, "times takes reset or nothing.", "Usage: times [reset]"};
  std::fputs(model.times.table().c_str(), stdout);
  std::fflush(stdout);
  return {};
}

} // namespace

std::vector<Command> time_commands() {
  Command times{
      "times",   "Times of the window",
      "[reset]", "Prints how long frames took, and steps until their picture was there; reset begins.",
      "",        nullptr,
      {},        tell_times};
  times.for_scripts = true;
  return {times};
}

} // namespace isoscope
