// What the batch program prints and the status it ends with.
#pragma once

#include "base/status.h"

#include <string>
#include <string_view>

namespace isoscope {

/// 2 usage, 3 bad input, 4 stopped, 1 anything else.
int exit_status(ErrorCode code);
/// Prints the error to standard error; returns `status`.
int fail(const Error& error, int status);
/// The same with the status of the error's code.
int fail(const Error& error);
/// Writes to standard output and makes sure that it arrived.
Status print(const std::string& text);
/// Prints what alone was asked for (help, the version, a list); the exit status. A reader that has had
/// enough, as `head` has, is no failure; a full disk is.
int answer(const std::string& text);
/// A line of a summary: the label, padded to a column, and the text.
std::string line(std::string_view label, const std::string& text);

} // namespace isoscope
