// Events in words, with the paper's symbols and units: captions, event lists and logs all use these.
#pragma once

#include "journal/journal.h"

#include <string>

namespace isoscope {

/// "37 · condition 1: sample 412 with ε = 1.83 (limit 0.80) goes in": an operation's number goes before it.
std::string describe(const Journal& journal, const Event& event);
/// The same without the number.
std::string describe_event(const Journal& journal, const Event& event);
/// For an audience, in words that need no knowledge of the paper's conditions: "refinement 37: the sample
/// with the largest error, 1.83, goes in". One line of at most 100 characters, but for warnings, which are
/// told in full. Lengths are in units of δ.
std::string plain_words(const Journal& journal, const Event& event);
/// What the event's value is: its kind says it, else its reason, else its condition.
Measure measure_of(const Event& event);

} // namespace isoscope
