// Reading and writing the settings file.
#include "model/settings.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace isoscope {
namespace {

using nlohmann::json;
constexpr std::size_t recent_limit = 10, filter_limit = 8;

float number(const json& object, const char* key, float fallback, float low, float high) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return fallback;
  return std::clamp(found->get<float>(), low, high);
}

bool flag(const json& object, const char* key, bool fallback) {
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() ? found->get<bool>() : fallback;
}

} // namespace

void Settings::add_recent(const std::string& input) {
  std::erase(recent, input);
  recent.insert(recent.begin(), input);
  if (recent.size() > recent_limit) recent.resize(recent_limit);
}

std::filesystem::path settings_file() {
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config && *config)
    return std::filesystem::path(config) / "isoscope" / "settings.json";
  if (const char* home = std::getenv("HOME"); home && *home)
    return std::filesystem::path(home) / ".config" / "isoscope" / "settings.json";
  return {};
}

Settings load_settings(const std::filesystem::path& file) {
  Settings s;
  std::ifstream in(file);
  if (!in) return s;
  const json object = json::parse(in, nullptr, false);
  if (!object.is_object()) return s;
  s.panes.left = number(object, "left", s.panes.left, 200, 900);
  s.panes.right = number(object, "right", s.panes.right, 200, 900);
  s.panes.bottom = number(object, "bottom", s.panes.bottom, 100, 900);
  s.panes.show_left = flag(object, "show_left", true);
  s.panes.show_right = flag(object, "show_right", true);
  s.panes.show_bottom = flag(object, "show_bottom", true);
  s.panes.tab = static_cast<BottomTab>(static_cast<int>(number(object, "tab", 0, 0, bottom_tab_count - 1)));
  s.theme = static_cast<ThemeKind>(static_cast<int>(number(object, "theme", 0, 0, 2)));
  s.ui_scale = number(object, "ui_scale", 1, 0.5f, 4);
  s.history_limit = static_cast<double>(number(object, "history_limit", 2048, 1, 1048576));
  s.greeted = flag(object, "greeted", false);
  s.coach_closed = static_cast<std::uint8_t>(number(object, "coach_closed", 0, 0, 255));
  if (const auto last = object.find("last_folder"); last != object.end() && last->is_string())
    s.last_folder = last->get<std::string>();
  if (const auto recent = object.find("recent"); recent != object.end() && recent->is_array())
    for (const json& entry : *recent)
      if (entry.is_string() && s.recent.size() < recent_limit) s.recent.push_back(entry.get<std::string>());
  if (const auto filters = object.find("filters"); filters != object.end() && filters->is_array())
    for (const json& entry : *filters)
      if (entry.is_string() && s.filters.size() < filter_limit) s.filters.push_back(entry.get<std::string>());
  return s;
}

void save_settings(const std::filesystem::path& file, const Settings& s) {
  if (file.empty()) return;
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  const json object = {{"left", s.panes.left},
                       {"right", s.panes.right},
                       {"bottom", s.panes.bottom},
                       {"show_left", s.panes.show_left},
                       {"show_right", s.panes.show_right},
                       {"show_bottom", s.panes.show_bottom},
                       {"tab", static_cast<int>(s.panes.tab)},
                       {"theme", static_cast<int>(s.theme)},
                       {"ui_scale", s.ui_scale},
                       {"history_limit", s.history_limit},
                       {"greeted", s.greeted},
                       {"coach_closed", s.coach_closed},
                       {"last_folder", s.last_folder},
                       {"filters", s.filters},
                       {"recent", s.recent}};
  std::ofstream out(file);
  out << object.dump(2) << '\n';
}

} // namespace isoscope
