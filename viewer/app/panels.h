// The panels by name: each draws itself into the present window of the interface.
#pragma once

#include "ui/ui.h"

namespace isoscope::panels {

void layers(Ui& ui);
void parameters(Ui& ui);
void clip_and_filter(Ui& ui);
void inspector(Ui& ui);
/// The X-ray of the selected edge: verdict, checks, kernel, candidates, cost; after T what the journal tells.
void edge_details(Ui& ui, const StateSnapshot& state);
void top_bar(Ui& ui);
void status_bar(Ui& ui);
/// A card with bar and Cancel while something is exported; `low` is the view's lower left corner.
void export_progress(Ui& ui, ImVec2 low, float width);
void messages(Ui& ui, ImVec2 low, float width);
/// Presenting: the sentence of the step shown, and where in the run it is.
void presenter_bar(Ui& ui);
/// Number and note of the bookmark that is shown, over the view; `low` is the view's corner.
void slide_title(const Ui& ui, ImVec2 low, float width);

} // namespace isoscope::panels
