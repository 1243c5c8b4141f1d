// What is remembered between sessions: pane sizes, theme, scale, recent files. A small JSON file in the
// user's configuration.
#pragma once

#include "scene/view_settings.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace isoscope {

/// What the bottom pane shows; kept by number.
enum class BottomTab : std::uint8_t {
  timeline,
  plots,
  events,
  breakpoints,
  history,
  work,
  compare,
  tolerance,
  loops
};
constexpr int bottom_tab_count = static_cast<int>(BottomTab::loops) + 1;

/// Sizes in units of the interface, before scaling.
struct PaneLayout {
  float left = 300, right = 340, bottom = 232;
  bool show_left = true, show_right = true, show_bottom = true;
  BottomTab tab = BottomTab::timeline;
  friend bool operator==(const PaneLayout&, const PaneLayout&) = default;
};

struct Settings {
  PaneLayout panes;
  ThemeKind theme = ThemeKind::dark;
  float ui_scale = 1;              ///< on top of the monitor's content scale, in [0.5, 4]
  double history_limit = 2048;     ///< of journal and keyframes together, MiB, in [1, 1048576]
  bool greeted = false;            ///< the three ways in were shown
  std::uint8_t coach_closed = 0;   ///< marks at parts of the window that do not come back, as bits
  std::vector<std::string> recent; ///< newest first, at most ten
  std::string last_folder;
  std::vector<std::string> filters; ///< of events, each a lane of the timeline; at most eight

  void add_recent(const std::string& input);
};

/// $XDG_CONFIG_HOME/isoscope/settings.json, or under ~/.config; empty where there is neither.
std::filesystem::path settings_file();
/// Defaults where the file is missing or damaged.
Settings load_settings(const std::filesystem::path& file);
/// Best effort: a read-only home is no error.
void save_settings(const std::filesystem::path& file, const Settings& settings);

} // namespace isoscope
