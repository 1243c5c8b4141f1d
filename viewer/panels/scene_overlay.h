// What lies over the view: axes, scale bar, the sentence of the current operation, mode switch, hover,
// progress.
#pragma once

#include "panels/ui.h"

namespace isoscope::overlay {

/// `corner`: the view's top right.
void mode_switch(Ui& ui, ImVec2 corner);
void axes(const Ui& ui, ImVec2 low, ImVec2 size);
/// `height`: scene units over the view's height.
void scale_bar(const Ui& ui, ImVec2 low, ImVec2 size, double height);
void caption(const Ui& ui, ImVec2 low, ImVec2 size);
void section_caption(const Ui& ui, ImVec2 low, ImVec2 size);
void hover_tip(const Ui& ui);
/// What to do where there is no model: open one, or choose from the gallery.
void invitation(Ui& ui, ImVec2 low, ImVec2 size);
/// What is being prepared, with Cancel.
void progress(Ui& ui, ImVec2 low, ImVec2 size);

} // namespace isoscope::overlay
