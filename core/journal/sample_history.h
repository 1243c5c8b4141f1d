// When a sample changed class: its tetrahedron is followed through the deltas, none of which is judged unless
// it touches that tetrahedron.
#pragma once

#include "journal/history.h"

namespace isoscope {

/// The rows of one sample of the set in force at step `at`, whose T is `state`; both ways, to where another
/// set is in force.
std::vector<HistoryRow> sample_class_changes(const Journal& journal, SampleId sample, const Complex& state,
                                             Step at, const RunControl& control);
/// Of these the last one that shows before step `at`, read backwards from there and no further.
std::optional<HistoryRow> last_class_change(const Journal& journal, SampleId sample, const Complex& state,
                                            Step at, const RunControl& control);

} // namespace isoscope
