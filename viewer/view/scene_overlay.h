// What lies over the view: axes, scale bar, the sentence of the current operation, mode switch, hover,
// progress.
#pragma once

#include "ui/ui.h"

#include <string>

namespace isoscope::overlay {

/// `corner`: the view's top right.
void mode_switch(Ui& ui, ImVec2 corner, float room);
void axes(const Ui& ui, const Camera& camera, ImVec2 low, ImVec2 size);
/// `height`: scene units over the view's height; nothing where `delta` is 0.
void scale_bar(const Ui& ui, double delta, ImVec2 low, ImVec2 size, double height);
/// An event's text in the top left corner with its glyph; null: none led here. It has `room` pixels, and is
/// cut to that many lines. Returns its height, 0 where there is no room.
float sentence(const Ui& ui, const Event* event, std::string text, ImVec2 low, float room, int lines = 1);
/// That of the step, beside the mode switch, or below it where that leaves little. What is lower goes down by
/// what comes back, in pixels.
float caption(const Ui& ui, ImVec2 low, ImVec2 size);
/// At which δ Ω is shown, where that is not the run's.
void preview(const Ui& ui, ImVec2 low, ImVec2 size);
void section_caption(const Ui& ui, ImVec2 low, ImVec2 size);
void hover_tip(const Ui& ui);
/// What to do where there is no model: open one, or choose from the gallery.
void invitation(Ui& ui, ImVec2 low, ImVec2 size);
/// What is being done, in words and as a bar: part of it, or < 0 where that is not known. With Cancel, which
/// posts the command, where there is one.
void progress_box(Ui& ui, const std::string& text, double fraction, const char* cancel, ImVec2 at,
                  float width);
/// How high it is.
float progress_box_height(const Ui& ui, bool with_cancel);
/// What is being prepared of a run, with Cancel, which posts the command.
void progress(Ui& ui, const ShownRun& run, const char* cancel, ImVec2 low, ImVec2 size);

} // namespace isoscope::overlay
