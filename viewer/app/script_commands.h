// Commands made for scripts, and how long the window takes, which they measure.
#pragma once

#include "app/app_model.h"

namespace isoscope {

void add_script_commands(AppModel& model);
void add_time_values(AppModel& model);

} // namespace isoscope
