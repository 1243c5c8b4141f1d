// Named values of the view, the X-ray's drawing and the window's look.
#pragma once

#include "command/named_values.h"
#include "model/window_state.h"

namespace isoscope {

void add_view_values(NamedValues& values, WindowState& window);

} // namespace isoscope
