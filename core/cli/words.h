// Words that the batch program's summaries are made of.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace isoscope {

/// "1,204 events", "1 event"; `plural` where it is not the noun with an s.
std::string counted(std::size_t n, const std::string& noun, const std::string& plural = {});
/// A line of a summary: the label, padded to a column, and the text.
std::string line(std::string_view label, const std::string& text);

} // namespace isoscope
