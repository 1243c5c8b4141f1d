// Events in plain words, with the paper's symbols and units: captions, event lists and logs all use these.
#pragma once

#include "journal/journal.h"

#include <string>

namespace isoscope {

/// "37 · condition 1: sample 412 with ε = 1.83 (limit 0.80) goes in": an operation's number goes before it.
std::string describe(const Journal& journal, const Event& event);
/// The same without the number.
std::string describe_event(const Journal& journal, const Event& event);

} // namespace isoscope
