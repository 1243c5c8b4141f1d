// What the pipeline aims at beside Lindstrom–Turk: sums and medians over named models, and how far they are.
#pragma once

#include "bench/cases.h"
#include "bench/table.h"

#include <cstdint>
#include <string>
#include <vector>

namespace isoscope::bench {

/// The lines that the targets are made of, each once; without those of all models and of small tolerances
/// unless `complete`. Models that are not installed are left out.
std::vector<Case> cases_of_targets(bool complete);

/// The input moved by less than δ along each axis, the same for the same seed; by nothing for seed 0. What
/// comes of it differs by luck alone.
TriangleSoup nudged(TriangleSoup soup, double delta, std::uint32_t seed);

/// One line for each target that has rows: its mean over the seeds and the least and largest, the floor that
/// must be reached and the goal. Rows that are not certified are left out; how many count is told.
std::string target_table(const std::vector<Row>& rows, bool markdown);

} // namespace isoscope::bench
