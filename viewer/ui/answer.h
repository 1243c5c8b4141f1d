// The part of a pane that answers a question: scrolled to when it was asked for and lies out of sight, and
// flashing when it has come.
#pragma once

#include "ui/ui.h"

namespace isoscope::widgets {

/// From the cursor to where it stands at the end of the block.
class AnswerRegion {
 public:
  /// `ready`: the answer is there; before that what is said of the waiting is brought into sight.
  AnswerRegion(Ui& ui, AnswerKind which, bool ready = true);
  ~AnswerRegion();
  AnswerRegion(const AnswerRegion&) = delete;
  AnswerRegion& operator=(const AnswerRegion&) = delete;

 private:
  Ui& ui_;
  AnswerKind which_;
  bool ready_;
  ImVec2 at_;
  float width_;
};

} // namespace isoscope::widgets
