// Conditions worth stopping at, made from what is selected and where one stands.
#pragma once

#include <string>
#include <vector>

namespace isoscope {

class Debugger;

struct SuggestedBreak {
  std::string condition; ///< in the language of breakpoints
  std::string words;     ///< "this edge, for this reason"
};

/// The first is what F9 breaks on; empty where nothing is selected and no event led here.
std::vector<SuggestedBreak> suggested_breaks(const Debugger& debugger);
/// Whether there is a breakpoint with just this condition.
bool breaks_on(const Debugger& debugger, const std::string& condition);

} // namespace isoscope
