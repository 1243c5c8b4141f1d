// The parts that the table of named values is put together from.
#pragma once

#include "command/named_values.h"

#include <vector>

namespace isoscope {

using NamedTable = std::vector<NamedValue>;

/// A number with all digits that tell it apart.
std::string text_of(double value);
/// Of the recording that is written or shown.
void add_recording_readings(NamedTable& table);
/// What can only be read: the run, the state, the selection.
void add_readings(NamedTable& table);
/// The same of what is asked of an edge.
void add_edge_readings(NamedTable& table);
/// The same of the debugger.
void add_debug_readings(NamedTable& table);
/// What the questions about elements, work, topology and validity answer, and their settings.
void add_questions(NamedTable& table);
/// The second run and what differs.
void add_comparison(NamedTable& table);
/// Bookmarks, undo and the presenter mode.
void add_slide_values(NamedTable& table);
/// How long the window takes.
void add_time_readings(NamedTable& table);
/// Exports and the memory of the history.
void add_export_values(NamedTable& table);

} // namespace isoscope
