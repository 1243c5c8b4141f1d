// What is the same in the page of every sweep.
#pragma once

namespace isoscope::sweep {

/// The style sheet, for light and dark screens.
extern const char* const page_style;
/// Sorts, filters and fills the table from the rows that stand in the page as JSON.
extern const char* const page_script;

} // namespace isoscope::sweep
