// The lines that the batch program's summaries are made of.
#pragma once

#include "base/numbers.h"

#include <string>
#include <string_view>

namespace isoscope {

/// A line of a summary: the label, padded to a column, and the text.
std::string line(std::string_view label, const std::string& text);

} // namespace isoscope
