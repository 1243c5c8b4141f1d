// The batch program's exit status and the line it complains with.
#pragma once

#include "base/status.h"

#include <string>

namespace isoscope {

/// 2 usage, 3 bad input, 4 stopped, 1 anything else.
int exit_status(ErrorCode code);
/// Prints the error to standard error; returns `status`.
int fail(const Error& error, int status);
/// The same with the status of the error's code.
int fail(const Error& error);
/// Writes to standard output and makes sure that it arrived.
Status print(const std::string& text);

} // namespace isoscope
