// The dialog for pictures and films, and the card that tells how far an export is.
#pragma once

#include "export/exports.h"
#include "ui/ui.h"

#include <array>

namespace isoscope {

/// Size, ground and kind of the pictures and films to be written.
class ExportDialog {
 public:
  /// Fills the present window of the interface; posts the command that does what is chosen.
  void draw(Ui& ui, const Exports& exports);

 private:
  void steps(Ui& ui);
  void export_button(Ui& ui, const Exports& exports);
  enum Kind { picture, figure, turntable, step_frames };
  int kind_ = picture;
  int width_ = 1920, height_ = 1080;
  int frames_ = 120, from_ = 0, to_ = 0, every_ = 1, rate_ = 25;
  bool alpha_ = false, film_ = false, fresh_ = true;
  std::array<char, 512> name_{};
};

namespace panels {

/// A card with bar and Cancel while something is exported; `low` is the view's lower left corner.
void export_progress(Ui& ui, const Exports& exports, ImVec2 low, float width);

} // namespace panels
} // namespace isoscope
