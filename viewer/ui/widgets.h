// Small pieces that several panels share: icon buttons, value rows, limit bars, section titles, tooltips.
#pragma once

#include "journal/vocabulary.h"
#include "ui/ui.h"

#include <span>
#include <string>
#include <string_view>

namespace isoscope::widgets {

/// A tooltip for the last item after half a second: a title in bold and a paragraph below.
void tip(const Ui& ui, std::string_view title, std::string_view text = {});
/// A tooltip made from a command: its title, key and help.
void command_tip(const Ui& ui, std::string_view command);

/// The font of what follows, to the end of the block.
class Font {
 public:
  explicit Font(ImFont* font) { ImGui::PushFont(font); }
  ~Font() { ImGui::PopFont(); }
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;
};

/// A row from the cursor over the width that is left, or over `width` pixels: what stands in it is placed by
/// its left end and at the height of the row's middle. Other lengths are in units of the interface.
class Row {
 public:
  Row(const Ui& ui, float high, float width = 0);
  /// All of it as a button: true when pressed.
  bool button(const char* id);
  bool button(std::size_t id);
  bool hovered() const { return hovered_; }
  void ground(Rgb color, float alpha = 1, float margin = 0) const;
  /// As a button that leads somewhere: a ground and a hand below the mouse.
  void link() const;
  void text(ImFont* font, float x, Rgb color, std::string_view text, float alpha = 1) const;
  /// The same, cut to a width in pixels.
  void fitted(ImFont* font, float x, Rgb color, std::string_view text, float room, float alpha = 1) const;
  /// A step's number, its right end where the glyphs of a list of events begin.
  void step(Step step) const;
  /// Flush right in the monospaced font; the width it took, in pixels.
  float value(Rgb color, std::string_view text, float alpha = 1) const;
  /// A label on the left and a value flush right; where there is no room for both they are cut, the label
  /// first.
  void pair(Rgb label_color, std::string_view label, Rgb color, std::string_view shown) const;
  void glyph(float x, Rgb color, MarkerShape shape, float radius = 4.5f) const;
  /// A disc or a cross.
  void verdict(float x, bool good) const;
  /// Where a text of that font begins, from above.
  float y(const ImFont* font) const { return at.y + (high - font->FontSize) / 2; }
  /// Goes on below it: with the spacing of items, or right there.
  void item() const { ImGui::Dummy({width, high}); }
  void below() const { ImGui::SetCursorScreenPos({at.x, at.y + high}); }

  ImVec2 at;
  float width, high;
  ImDrawList& list;

 private:
  const Ui& ui_;
  bool hovered_ = false;
};

/// Calls draw(i) for the rows of a list that are in sight, of equal height in pixels and without gaps.
template <class Draw> void rows_in_sight(std::size_t count, float high, Draw draw, float gap = 0) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, 0});
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(count), high);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) draw(static_cast<std::size_t>(i));
  ImGui::PopStyleVar();
}

/// A flat button with an icon; `lit` shows it as switched on. True when pressed.
bool icon_button(const Ui& ui, const char* id, const char* icon, bool lit = false, bool enabled = true,
                 float width = 0);
/// An icon button that posts a command; disabled when the command is.
void command_button(const Ui& ui, std::string_view command, const char* icon = nullptr,
                    Arguments arguments = {});
/// The same with the command's key beside its icon.
void key_button(const Ui& ui, std::string_view command, float width);
/// A filled button with text in the accent colour.
bool primary_button(const Ui& ui, const char* label, bool enabled = true, float width = 0);
/// The next button stands beside the last item where its label has room there, else below it.
void beside_or_below(const Ui& ui, const char* label, float gap = 6);
/// A button without weight.
bool plain_button(const Ui& ui, const char* label, bool enabled = true, float width = 0, float height = 0);

/// A pane's section with a title that folds it; call the content only when true.
bool section(const Ui& ui, const char* title, bool open_at_first = true);
void bold_text(const Ui& ui, std::string_view text);
/// A bold title within a section, with room above.
void subtitle(const Ui& ui, const char* text);
/// A quiet label on the left, a monospaced value flush right.
void value_row(const Ui& ui, std::string_view label, std::string_view value, Rgb color = 0);
/// A row that selects what it names: true when clicked. Rows of one list differ by their number.
bool link_row(const Ui& ui, const char* id, std::string_view label, std::string_view value,
              std::string_view hint = {}, std::size_t number = 0);
/// A number beside its limit: a bar on [0, reach] with the limit marked. `good`: the number keeps it.
void limit_bar(const Ui& ui, std::string_view label, double value, double limit, bool good,
               std::string_view unit, bool limit_is_upper);

/// A switch with an accent-coloured track. True when changed.
bool toggle(const Ui& ui, const char* id, bool& on);
/// Buttons of which one is lit. True when changed.
bool segmented(const Ui& ui, const char* id, std::span<const char* const> labels, int& chosen,
               float width = 0);
/// A slider with its value in the field, over the width that is left.
bool slider(const Ui& ui, const char* id, float& value, float low, float high, const char* format,
            bool logarithmic = false);
/// A slider that a number may be typed into, also one out of its range. The number stands beside the knob
/// where that would cover it.
bool numbered_slider(const Ui& ui, const char* id, float& value, float low, float high, const char* format,
                     bool logarithmic = false);

/// The head of an inspector: what is selected, with buttons to frame and to clear it, and a quiet note.
void heading(Ui& ui, const char* icon, const std::string& title, const std::string& note);
/// Good: a disc; bad: a cross; drawn at the cursor like a glyph of the present line.
void verdict_glyph(const Ui& ui, bool good);
/// The same with a sentence behind it, small.
void verdict_text(const Ui& ui, bool good, std::string_view text);
/// The colour and the hatch of a side where there are several insides.
void room_swatch(const Ui& ui, ImVec2 low, ImVec2 high, int label);
/// A mark of the view in a panel; the radius in units of the interface.
void glyph(const Ui& ui, ImVec2 middle, float radius, Rgb color, MarkerShape shape);
void quiet_text(const Ui& ui, std::string_view text, bool wrapped = false);
/// In the present font over the width that is left, or over that many pixels, as ui/word_wrap.h breaks it.
void wrapped_text(std::string_view text, float width = 0);
/// The text with its line feeds, for what is drawn by other means.
std::string broken_lines(const ImFont* font, std::string_view text, float width);
float height_of(const ImFont* font, const std::string& lines);
/// Text cut with an ellipsis to a width.
std::string fitted(std::string_view text, float width);
/// The same over at most so many lines, broken at blanks.
std::string fitted(std::string_view text, float width, int lines);
/// A speed of the play head: "¼×", "64×", "auto", "max".
std::string speed_text(double steps_per_second);
/// In the present font.
ImVec2 text_size(std::string_view text);
float width_of(const ImFont* font, std::string_view text);
void draw_text(ImDrawList& list, ImFont* font, ImVec2 at, ImU32 color, std::string_view text);

} // namespace isoscope::widgets
