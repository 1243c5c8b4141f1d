// In windows of any size what is written can be read: no words lie on other words, none is cut without a
// sign.
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace isoscope::test;
namespace fs = std::filesystem;

namespace {

const fs::path results = ISOSCOPE_RESULTS;

/// What the command "words" wrote of one piece of text.
struct Written {
  float left = 0, top = 0, right = 0, bottom = 0;
  bool cut = false;
  std::string surface, text;
};

std::vector<Written> written(const fs::path& file) {
  std::vector<Written> all;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    Written w;
    std::string cut;
    fields >> w.left >> w.top >> w.right >> w.bottom;
    fields.ignore(1);
    std::getline(fields, cut, '\t');
    std::getline(fields, w.surface, '\t');
    std::getline(fields, w.text);
    w.cut = cut == "cut";
    all.push_back(w);
  }
  return all;
}

bool overlap(const Written& a, const Written& b) {
  const float wide = std::min(a.right, b.right) - std::max(a.left, b.left),
              high = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return a.surface == b.surface && wide > 2 && high > 0.3f * std::min(a.bottom - a.top, b.bottom - b.top);
}

void check_legible(const fs::path& file) {
  CAPTURE(file.filename().string());
  const std::vector<Written> all = written(file);
  CHECK(all.size() > 5);
  for (std::size_t i = 0; i < all.size(); ++i) {
    CAPTURE(all[i].text);
    CHECK(!all[i].cut);
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      CAPTURE(all[k].text);
      // The same words twice are one: a heading drawn over itself.
      CHECK(!(all[i].text != all[k].text && overlap(all[i], all[k])));
    }
  }
}

/// States that show what there is: commands, by their name.
struct ShownState {
  const char *name, *commands;
};
constexpr std::array shown_states{
    ShownState{"end", ""},
    ShownState{"edge", "stage zero-set\nnext-event rejection\nwait answers"},
    ShownState{"events", "tab events\nwait answers"},
    ShownState{"plots", "tab plots\nwait answers"},
    ShownState{"work", "work\nwait answers"},
    ShownState{"breakpoints", "tab breakpoints\nbreak reject && reason == normals"},
    ShownState{"history", "history\nwait answers"},
    ShownState{"sample", "tab timeline\nclear\nseek 30\nwait answers\npick-worst\nwait answers"},
    ShownState{"tet", "next-violation\nwait answers\nsplit"},
    ShownState{"parameters", "clear\nscene\nset alpha 0.5\nwait answers"},
    ShownState{"wrong", "type alpha 2\nwait answers"},
    ShownState{"legend", "type alpha 0.5\ncolour-by distance\nlegend\nwait answers"},
    ShownState{"gallery", "colour-by none\nlegend\ngallery\nwait until gallery.ready == on"},
    ShownState{"help", "clear\nhelp"},
    ShownState{"palette", "clear\npalette"},
    ShownState{"welcome", "clear\nwelcome"},
    ShownState{"lessons", "clear\nlesson"},
    ShownState{"bookmarks", "clear\nbookmarks"},
    ShownState{"pictures", "clear\npictures"},
    ShownState{"about", "clear\nabout"},
    ShownState{"files", "clear\nopen"},
    ShownState{"presenter", "clear\npresenter\nwait answers"},
    ShownState{"two-runs", "clear\nrun-beside\nwait settled\nend\nwait settled"},
    ShownState{"lesson", "close-other\nlesson tessellation 2\nwait settled\nwait answers"},
};

void read_all(const std::string& size, const std::string& theme, const std::string& scale) {
  const fs::path folder = results / (size + "-" + scale);
  fs::create_directories(folder);
  std::string script = "theme " + theme + "\nwait settled\n";
  for (const ShownState& state : shown_states)
    script += std::string(state.commands) + "\nwait 0.3\nwords " + (folder / state.name).string() + ".txt\n";
  REQUIRE(run_window("legible-" + size, script + "quit\n",
                     "gallery:bracket --until zero-set --size " + size + " --ui-scale " + scale) == 0);
  for (const ShownState& state : shown_states) check_legible(folder / (std::string(state.name) + ".txt"));
}

} // namespace

TEST_CASE("at 700 × 480 nothing overlaps, and nothing is cut without a sign") {
  read_all("700x480", "light", "1");
}

TEST_CASE("nor at 1000 × 700") {
  read_all("1000x700", "dark", "1");
}

TEST_CASE("nor with text twice as large in a window of 1280 × 800") {
  read_all("1280x800", "paper", "2");
}
