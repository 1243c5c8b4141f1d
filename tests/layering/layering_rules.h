// The rules that every source file keeps: allowed includes by folder, a purpose comment, length, forbidden
// words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isoscope::layering {

/// The rules that the file breaks, one sentence each, empty if none.
/// `path` is relative to the repository with forward slashes ("core/mesh/complex.cpp"); its folder picks the
/// rules.
std::vector<std::string> broken_rules(std::string_view path, std::string_view text);

} // namespace isoscope::layering
