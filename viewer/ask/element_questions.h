// What the inspector adds under an element.
#pragma once

#include "ask/investigation.h"
#include "ui/ui.h"

namespace isoscope::panels {

/// Under a tetrahedron: next and previous violation, the factor of the copy that is drawn, what goes in.
void tet_questions(Ui& ui, Investigation& asked, const StateSnapshot& state, std::uint32_t id);
/// Under a sample: who mends it.
void sample_questions(Ui& ui, const StateSnapshot& state, std::uint32_t id);
/// Under tetrahedra, samples and edges: which parameters would change the verdict.
void advice(Ui& ui, const Investigation& asked);
/// Buttons for the history and the last change of the selection.
void history_buttons(Ui& ui);

} // namespace isoscope::panels
