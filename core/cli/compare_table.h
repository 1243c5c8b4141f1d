// A run's stages side by side, as Table 1 of the paper.
#pragma once

#include "run/statistics.h"

#include <string>
#include <vector>

namespace isoscope {

/// Stage, operations, vertices of Z, seconds, time per operation, rejections; below it the rejections by
/// reason, how targets were found, and what repairs took. Plain text, ending in a newline.
std::string compare_table(const std::vector<StageStatistics>& stages);

} // namespace isoscope
