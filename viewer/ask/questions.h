// The parts of panels that show answers of the Investigation.
#pragma once

#include "ui/ui.h"
#include "questions/snapshot.h"

namespace isoscope::panels {

/// Under a tetrahedron: next and previous violation, the factor of the copy that is drawn, what goes in.
void tet_questions(Ui& ui, const StateSnapshot& state, std::uint32_t id);
/// Under a sample: who mends it.
void sample_questions(Ui& ui, const StateSnapshot& state, std::uint32_t id);
/// Under tetrahedra, samples and edges: which parameters would change the verdict.
void advice(Ui& ui);
/// Buttons for the history and the last change of the selection.
void history_buttons(Ui& ui);
/// Breakpoints on the selection, the gate or the event shown.
void break_rows(Ui& ui);
/// Of the whole state: violations, topology, validity.
void state_questions(Ui& ui, const StateSnapshot& state);
/// The bottom tabs.
void history_tab(Ui& ui);
void work_tab(Ui& ui);
void compare_tab(Ui& ui);

} // namespace isoscope::panels
