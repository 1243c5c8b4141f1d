// What has no room, lies below the fold or needs a word says so: menus in groups, answers that are scrolled
// to and flash, the status bar's numbers, lanes of the timeline that are left out.
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace isoscope::test;
namespace fs = std::filesystem;

namespace {

std::string result(const std::string& name) {
  return (fs::path(ISOSCOPE_RESULTS) / name).string();
}

/// The tops of the entries of an open menu, by the words at its left, downwards.
std::vector<float> menu_rows(const std::string& file) {
  std::vector<float> tops;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.find("##Popup") == std::string::npos) continue;
    std::istringstream fields(line);
    float left = 0, top = 0;
    fields >> left >> top;
    tops.push_back(top);
  }
  std::sort(tops.begin(), tops.end());
  std::vector<float> rows;
  for (const float top : tops)
    if (rows.empty() || top - rows.back() > 6) rows.push_back(top);
  return rows;
}

} // namespace

TEST_CASE("long menus are divided into groups") {
  const std::vector<std::string> menus{"File", "Run", "Select", "Ask", "View", "Talk"};
  std::string script = "wait settled\n";
  for (const std::string& menu : menus)
    script +=
        "menu " + menu + "\nwait 0.3\nexpect menu == " + menu + "\nwords " + result(menu + ".txt") + "\n";
  REQUIRE(run_window("menu-groups", script + "quit\n",
                     "gallery:sphere --tolerance 12% --until refinement --size 1280x1000") == 0);
  for (const std::string& menu : menus) {
    CAPTURE(menu);
    const std::vector<float> rows = menu_rows(result(menu + ".txt"));
    REQUIRE(rows.size() > 4);
    float least = 1000;
    for (std::size_t i = 1; i < rows.size(); ++i) least = std::min(least, rows[i] - rows[i - 1]);
    // A line between groups takes more room than entries of one.
    std::size_t longest = 1, group = 1, groups = 1;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const bool divided = rows[i] - rows[i - 1] > least + 3;
      groups += divided ? 1 : 0;
      group = divided ? 1 : group + 1;
      longest = std::max(longest, group);
    }
    CHECK(longest <= 9);
    if (rows.size() > 9) CHECK(groups >= 2);
  }
}

TEST_CASE("an answer below the fold is scrolled to and flashes for a moment") {
  CHECK(run_window("flash", R"(
wait settled
stage zero-set
next-event rejection outside-tolerance zero-set
wait answers
wait 2
expect inspector.scroll == 0 and answer.flashes == off
expect-no-words trials
unlock
wait answers
wait 0.2
expect answer == unlock and answer.flashes == on and inspector.scroll > 0
expect-words unlock
wait 2
expect answer.flashes == off
quit
)",
                   "gallery:bracket --effort 0 --until zero-set --size 1280x800") == 0);
}

TEST_CASE("the status bar explains its bad samples, before the proof stands in for them and after") {
  CHECK(run_window("status-tips", R"(
wait settled
expect bad_samples > 0 and certified == on
hover-words bad of
expect-words At a bad sample f has the wrong sign
expect-words Z may pass samples and is in Ω all the same
seek 30
wait settled
move 640 300
wait 0.2
hover-words bad of
expect-words Refinement inserts points until there is none
quit
)",
                   "gallery:bracket --until all --effort 0 --size 1280x800") == 0);
}

TEST_CASE("lanes that have no room are counted and named, and a click gives it to them") {
  CHECK(run_window("left-out",
                   R"(
wait settled
expect loop.lanes > 3
tab timeline
wait 0.2
expect-words hole 1
expect-words lanes, +
expect-no-words Lanes without room
hover-words lanes, +
expect-words Lanes without room
expect-words A click enlarges the pane
screenshot )" + result("left-out.png") +
                       R"(
click-words lanes, +
move 640 200
wait 0.3
expect-words hole 1
expect-words hole 4
expect-no-words lanes, +
screenshot )" + result("with-room.png") +
                       R"(
all-lanes
wait 0.3
expect-words lanes, +
quit
)",
                   "gallery:range-scan --size 1280x800") == 0);
}
