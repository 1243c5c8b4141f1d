// What differs between two runs, as text for a terminal.
#pragma once

#include "compare/compare_runs.h"

#include <cstddef>
#include <string>

namespace isoscope {

/// A run as the text names it.
struct ComparedRun {
  std::string name;
  const Journal& journal;
};

/// Parameters, stages, the first differences and at most `rows` decisions that only one run made, ending in a
/// newline.
std::string comparison_text(const RunComparison& found, const ComparedRun& a, const ComparedRun& b,
                            std::size_t rows);

} // namespace isoscope
