// What can be read in the window: the words of a frame, found by its glyphs.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// Letters that were drawn one after the other on a line.
struct SeenWords {
  std::string text;
  ImVec2 low, high;    ///< what of them lies within the window and its panes; pixels
  bool cut = false;    ///< more of them lies beside it
  std::string surface; ///< the window or pane in which they stand
};

/// The words of a frame, from the back to the front. What lies behind something else is among them.
std::vector<SeenWords> words_on_screen(const ImDrawData& frame, const ImFontAtlas& atlas);

/// Whether these words are among them, over lines too; blanks do not count.
bool can_be_read(const std::vector<SeenWords>& seen, std::string_view words);

/// The piece of them that has these words: one that has no others before all, and the one in front where
/// there are several; null where none has.
const SeenWords* find_words(const std::vector<SeenWords>& seen, std::string_view words);

} // namespace isoscope
