// Errors of commands that were asked for with wrong arguments.
#pragma once

#include "base/status.h"

#include <string>

namespace isoscope {

/// What is wrong, without a hint.
Error usage(const std::string& what);
/// What is wrong, and how the command of that name is used.
Error usage(const std::string& command, const std::string& what);

} // namespace isoscope
