// The look in one place: colours by role, the user interface's style and fonts. Panels take everything from
// here.
#pragma once

#include "base/status.h"
#include "journal/event.h"
#include "scene/view_settings.h"

#include <imgui.h>

#include <cstdint>

namespace isoscope {

/// A colour as 0xRRGGBB.
using Rgb = std::uint32_t;

/// Colours by role. The first group is grounds and text; the second carries meaning and is the same in every
/// theme but for what legibility asks of text.
struct Palette {
  Rgb ground, panel, raised, hover, line, text, quiet, accent;
  Rgb good, bad, warning, gamma, other_zero, zero, outer, inner, misoriented, kernel, rim, selection;
  Rgb good_text, bad_text, warning_text, accent_text; ///< readable on panel and raised
  Rgb on_accent;                                      ///< text on an accent-coloured ground
};
const Palette& palette(ThemeKind theme);

/// WCAG contrast of two colours, in [1, 21].
double contrast(Rgb a, Rgb b);

ImVec4 to_vec(Rgb color, float alpha = 1.0f);
ImU32 to_u32(Rgb color, float alpha = 1.0f);
/// The colour of a condition's marks in timeline, events and legend; index by Condition.
Rgb condition_color(ThemeKind theme, int condition);

/// The colour of a stage in the timeline, the chips and the plots.
Rgb stage_color(ThemeKind theme, Stage stage);

/// Fonts at one scale; owned by the atlas.
struct Fonts {
  ImFont* ui = nullptr;           ///< 15 px, with icons
  ImFont* bold = nullptr;         ///< 15 px semibold, with icons
  ImFont* small = nullptr;        ///< 13 px, with icons
  ImFont* title = nullptr;        ///< 22 px semibold
  ImFont* mono = nullptr;         ///< 13.5 px, fixed digits
  ImFont* reading = nullptr;      ///< 18 px, for longer text
  ImFont* reading_bold = nullptr; ///< 18 px semibold
};
/// Fills the atlas from the embedded fonts. Fails with device when one cannot be used.
Result<Fonts> load_fonts(ImFontAtlas& atlas, float scale);

/// Sets the whole style of the library at a scale.
void apply_style(ImGuiStyle& style, ThemeKind theme, float scale);

} // namespace isoscope
