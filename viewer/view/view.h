// What the room gives to the sum: commands and values of view and selection, the left pane's sections.
#pragma once

#include "command/commands.h"
#include "command/named_values.h"
#include "model/window_state.h"

namespace isoscope {

class EdgeProbe;

struct Ui;

/// Mode, camera, clip, what is drawn; and undo of it.
void add_view_commands(CommandTable& table, WindowState& window);
/// Takes the view that a JSON text describes; fails with usage where it describes none.
Status show_view(WindowState& window, const std::string& json);

/// The section through what is selected, and the handle of the clip.
void add_section_commands(CommandTable& table, WindowState& window, const EdgeProbe& probe);

/// Selecting elements by number.
void add_pick_commands(CommandTable& table, WindowState& window);
/// Clearing and framing the selection, and restricting it to a kind.
void add_selection_commands(CommandTable& table, WindowState& window);

/// Of the view, the X-ray's drawing and the window's look.
void add_view_values(NamedValues& values, WindowState& window);

namespace panels {

/// Sections of the left pane.
void layers(Ui& ui);
void clip_and_filter(Ui& ui);
/// How Ω is drawn; a part of the layers.
void volume_look(Ui& ui);

} // namespace panels

} // namespace isoscope
