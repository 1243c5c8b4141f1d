// A sweep as one page: what came of it, histograms, a table to sort with a picture of each result.
#pragma once

#include "sweep/work.h"

namespace isoscope::sweep {

/// HTML that needs no other file, but that pictures beyond 24 MB and meshes stay where they are in the
/// folder.
std::string page(const Folder& folder, const Plan& plan, const std::map<std::size_t, Row>& rows);

/// Writes it to the folder's index.html.
Status write_page(const Folder& folder, const Plan& plan, const std::map<std::size_t, Row>& rows);

} // namespace isoscope::sweep
