// The sentence of the step shown, in plain words.
#pragma once

#include "app/app_model.h"

#include <string>

namespace isoscope {

/// What the presenter mode says: of the chosen event, of the operation that led to the state shown, or of
/// what the program waits for.
std::string plain_caption(const AppModel& model);

} // namespace isoscope
