// The parts that the table of named values is put together from.
#pragma once

#include "app/named_values.h"

#include <vector>

namespace isoscope {

using NamedTable = std::vector<NamedValue>;

/// A number with all digits that tell it apart.
std::string text_of(double value);
/// What can only be read: the run, the state, the selection.
void add_readings(NamedTable& table);
/// Exports and the memory of the history.
void add_export_values(NamedTable& table);

} // namespace isoscope
