// A small file browser.
#pragma once

#include "ui/ui.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace isoscope {

/// Folders and models, bookmarks, a filter, a path to type.
class FileBrowser {
 public:
  void draw(Ui& ui);

 private:
  void go(const std::filesystem::path& folder);
  void sidebar(Ui& ui, float width);
  void listing(Ui& ui);
  /// A file was chosen.
  void chosen(Ui& ui, const std::string& file);
  struct Entry {
    std::string name;
    bool folder = false, tiles = false; ///< to go into; of a run in tiles, opened as a whole
    std::uintmax_t bytes = 0;
  };
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::string trouble_;
  std::array<char, 1024> path_{};
  std::array<char, 128> filter_{};
  FilesFor wanted_ = FilesFor::open; ///< what the entries are for
  bool fresh_ = true;
};

} // namespace isoscope
