// A sweep as one page: what came of it, histograms, a table to sort with a picture of each result.
#pragma once

#include "sweep/comparison.h"
#include "sweep/work.h"

namespace isoscope::sweep {

/// HTML that needs no other file, but that pictures beyond 24 MB and meshes stay where they are in the
/// folder.
std::string page(const Folder& folder, const Plan& plan, const std::map<std::size_t, Row>& rows);

/// What a later sweep does worse and better than an earlier one, as a page; their names stand in its heading.
std::string comparison_page(const Comparison& comparison, const std::string& before,
                            const std::string& after);

/// Writes it to the folder's index.html.
Status write_page(const Folder& folder, const Plan& plan, const std::map<std::size_t, Row>& rows);

} // namespace isoscope::sweep
