// The list of the run's bookmarks, with notes to type.
#pragma once

#include "talk/talk.h"
#include "ui/ui.h"

#include <array>
#include <optional>

namespace isoscope {

class BookmarkList {
 public:
  void draw(Ui& ui, const Talk& talk);

 private:
  void row(Ui& ui, const Bookmarks& bookmarks, std::size_t at);
  std::optional<std::size_t> editing_; ///< the one whose note is typed
  std::array<char, 512> text_{}, shown_{};
};

} // namespace isoscope
