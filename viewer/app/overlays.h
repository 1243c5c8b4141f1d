// What lies over the whole window: gallery, files, help, command palette, about.
#pragma once

#include "app/palette_entries.h"
#include "export/export_dialog.h"
#include "steering/file_browser.h"
#include "talk/bookmarks_panel.h"
#include "ui/thumbnails.h"
#include "ui/ui.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace isoscope {

class Overlays {
 public:
  explicit Overlays(const AppModel& model) : model_(model) {}
  /// `size` is the window's.
  void draw(Ui& ui, ImVec2 size);
  Thumbnails& thumbnails() { return thumbnails_; }
  /// The pictures of bundled_lessons(), which the program fills in: 0 where there is none.
  std::vector<std::uint32_t> lesson_textures;

 private:
  void gallery(Ui& ui);
  void help(Ui& ui);
  void palette(Ui& ui);
  void about(Ui& ui);
  void bookmarks(Ui& ui);
  const AppModel& model_;
  FileBrowser files_;
  BookmarkList bookmarks_;
  ExportDialog pictures_;
  Thumbnails thumbnails_;
  std::array<char, 128> query_{};
  int chosen_ = 0;
  std::vector<PaletteEntry> found_;
  std::string found_for_; ///< what was typed
  std::string completed_; ///< to be put into the field
  int section_ = -1;      ///< of the help, to be scrolled to
  float needed_ = 0;      ///< height of what stands in the panel, once it has been drawn
  Overlay shown_ = Overlay::none;
};

} // namespace isoscope
