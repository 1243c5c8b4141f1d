// Settings survive being written and read, and damage does no harm.
#include "model/settings.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace isoscope;

namespace {
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("isoscope-settings-" + std::to_string(getpid()));
  ~Folder() { std::filesystem::remove_all(path); }
};
} // namespace

TEST_CASE("what is saved is loaded") {
  const Folder folder;
  const auto file = folder.path / "deep" / "settings.json";
  Settings s;
  s.panes.left = 333;
  s.panes.show_right = false;
  s.theme = ThemeKind::paper;
  s.ui_scale = 1.5f;
  s.add_recent("a.off");
  s.add_recent("b.off");
  s.add_recent("a.off");
  save_settings(file, s);
  const Settings back = load_settings(file);
  CHECK(back.panes.left == doctest::Approx(333));
  CHECK(!back.panes.show_right);
  CHECK(back.theme == ThemeKind::paper);
  CHECK(back.ui_scale == doctest::Approx(1.5));
  CHECK(back.recent == std::vector<std::string>{"a.off", "b.off"});
}

TEST_CASE("damage and absence give defaults") {
  const Folder folder;
  CHECK(load_settings(folder.path / "none.json").panes.left == doctest::Approx(300));
  std::filesystem::create_directories(folder.path);
  const auto file = folder.path / "bad.json";
  std::ofstream(file) << R"({"left": "wide", "ui_scale": 1e9, "theme": 77, "recent": [1, "x"]})";
  const Settings s = load_settings(file);
  CHECK(s.panes.left == doctest::Approx(300));
  CHECK(s.ui_scale <= 4);
  CHECK(static_cast<int>(s.theme) <= 2);
  CHECK(s.recent == std::vector<std::string>{"x"});
  std::ofstream(file) << "{";
  CHECK(load_settings(file).recent.empty());
}

TEST_CASE("at most ten recent files are kept") {
  Settings s;
  for (int i = 0; i < 30; ++i) s.add_recent(std::to_string(i));
  CHECK(s.recent.size() == 10);
  CHECK(s.recent.front() == "29");
}
