// Events for an audience: what happens at a step, in words that need no knowledge of the paper's conditions.
#pragma once

#include "journal/journal.h"

#include <string>

namespace isoscope {

/// "refinement 37: the sample with the largest error, 1.83, goes in". One line of at most 100 characters, but
/// for warnings, which are told in full. Lengths are in units of δ.
std::string plain_words(const Journal& journal, const Event& event);

} // namespace isoscope
