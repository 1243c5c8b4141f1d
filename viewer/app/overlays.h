// What lies over the whole window: gallery, files, help, command palette, about.
#pragma once

#include "export/export_dialog.h"
#include "ui/thumbnails.h"
#include "ui/ui.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// A small file browser: folders and models, bookmarks, a filter, a path to type.
class FileBrowser {
 public:
  void draw(Ui& ui);

 private:
  void go(const std::filesystem::path& folder);
  void sidebar(Ui& ui, float width);
  void listing(Ui& ui);
  struct Entry {
    std::string name;
    bool folder = false;
    std::uintmax_t bytes = 0;
  };
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::string trouble_;
  std::array<char, 1024> path_{};
  std::array<char, 128> filter_{};
  bool fresh_ = true;
};

/// The bookmarks of the run, with notes to type.
class BookmarkList {
 public:
  void draw(Ui& ui);

 private:
  void row(Ui& ui, std::size_t at);
  std::optional<std::size_t> editing_; ///< the one whose note is typed
  std::array<char, 512> text_{}, shown_{};
};

class Overlays {
 public:
  /// `size` is the window's.
  void draw(Ui& ui, ImVec2 size);
  Thumbnails& thumbnails() { return thumbnails_; }

 private:
  void gallery(Ui& ui);
  void help(Ui& ui);
  void palette(Ui& ui);
  void about(Ui& ui);
  void bookmarks(Ui& ui);
  FileBrowser files_;
  BookmarkList bookmarks_;
  ExportDialog pictures_;
  Thumbnails thumbnails_;
  std::array<char, 128> query_{};
  int chosen_ = 0;
  Overlay shown_ = Overlay::none;
};

} // namespace isoscope
