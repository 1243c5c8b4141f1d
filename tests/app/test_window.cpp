// Sessions of the real window: scripts with expectations, pictures against references, a real mouse and
// keyboard.
#include "app/picture_regions.h"
#include "platform/image_file.h"
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

using namespace isoscope;
using namespace isoscope::test;
namespace fs = std::filesystem;

namespace {

const fs::path results = ISOSCOPE_RESULTS;
const fs::path reference = ISOSCOPE_REFERENCE;
/// Of a region of a window's picture; what a word more or less makes of it is more.
constexpr double most_difference = 0.06;

std::string picture(const std::string& name) {
  return (results / (name + ".png")).string();
}

void compare(const std::string& name) {
  const auto found = read_png(picture(name));
  REQUIRE(found.ok());
  if (std::getenv("ISOSCOPE_UPDATE_REFERENCES") != nullptr) {
    fs::create_directories(reference);
    REQUIRE(write_png(reference / (name + ".png"), *found).ok());
  }
  const auto expected = read_png(reference / (name + ".png"));
  REQUIRE(expected.ok());
  REQUIRE(found->width == expected->width);
  REQUIRE(found->height == expected->height);
  CAPTURE(name);
  const PictureDifference differs = compare_regions(*found, *expected);
  CHECK(differs.mean < 0.025);
  CAPTURE(differs.x);
  CAPTURE(differs.y);
  CHECK(differs.worst < most_difference);
}

} // namespace

TEST_CASE("a word that vanishes from a picture is found, noise in all of it is not") {
  Image before{640, 400, std::vector<std::uint8_t>(640 * 400 * 4, 40)}, after = before;
  // Twelve letters, a third of whose pixels are bright.
  for (int y = 203; y < 213; ++y)
    for (int x = 111; x < 191; x += 3) before.pixels[static_cast<std::size_t>((y * 640 + x) * 4 + 1)] = 220;
  for (int y = 203; y < 213; ++y)
    for (int x = 111; x < 191; x += 3)
      for (const int channel : {0, 2})
        before.pixels[static_cast<std::size_t>((y * 640 + x) * 4 + channel)] = 220;
  const PictureDifference word = compare_regions(before, after);
  CHECK(word.mean < 0.025);
  CHECK(word.worst > most_difference);
  CHECK(word.x >= 80);
  CHECK(word.x <= 168);
  for (std::size_t i = 0; i < after.pixels.size(); ++i) after.pixels[i] = i % 7 < 3 ? 47 : 35;
  const PictureDifference noise =
      compare_regions(after, Image{640, 400, std::vector<std::uint8_t>(640 * 400 * 4, 40)});
  CHECK(noise.worst < most_difference);
  CHECK(compare_regions(before, Image{}).mean == 1);
}

TEST_CASE("a run is watched, stepped and judged") {
  CHECK(run_window("steps", R"(
wait settled
expect phase == finished and bad_samples == 0 and certified == on
expect step == state_step
expect euler == 2
seek 3
expect step == 3 and state_step == 3 and bad_samples > 0
step 3
expect state_step == 6
back
expect state_step == 5
first
expect state_step == 0
end
wait settled
expect bad_samples == 0
pick-worst
expect selection == sample
clear
expect selection == none
key Right
quit
)",
                   "gallery:sphere --tolerance 12% --until refinement") == 0);
}

TEST_CASE("another model is shown whole; the same one, run again, from where one looked at it") {
  CHECK(run_window("another-model", R"(
wait settled
seek 5
wait settled
pick-worst
frame
wait settled
expect filled > 1.2
set tolerance 10%
restart
wait settled
expect filled > 1.2
open gallery:torus
wait settled
wait 0.5
expect filled < 1
quit
)",
                   "gallery:sphere --tolerance 12% --until refinement") == 0);
}

TEST_CASE("a held run is stepped at its live end") {
  CHECK(run_window("held", R"(
open gallery:sphere paused
wait settled
expect phase == paused
step 5
wait settled
expect phase == paused and steps >= 5 and state_step >= 5
hold
wait settled
expect phase == finished
quit
)") == 0);
}

TEST_CASE("parameters are applied and a run is begun again") {
  CHECK(run_window("parameters", R"(
wait settled
expect apply.would == nothing and draft.differs == off and draft.errors == 0 and forecast.seconds == nan
# The refinement has ended: α matters no more, but where it ended it does.
set alpha 0.5
wait settled
expect apply.would == too-late and apply.possible == off and apply.step > 0 and forecast.seconds > 0
apply-earlier
wait settled
expect phase == finished and runs == 2 and alpha == 0.5 and apply.would == nothing
# Wrong values are told and block what would take them.
type alpha 2
expect apply.would == wrong and draft.errors == 1
expect draft.error.alpha == "α is 2, which is not in (0, 1)."
type alpha 0.5
expect draft.errors == 0 and draft.error.alpha == none
set tolerance 10%
expect messages == 0 and apply.would == restart
restart
wait settled
expect phase == finished and bad_samples == 0
quit
)") == 0);
}

TEST_CASE("parameters go on from the step that is shown, and the run that was left is kept") {
  CHECK(run_window("parameters-branch", R"(
wait settled
seek 8
wait settled
set alpha 0.6
wait settled
expect apply.would == branch and apply.step == 8 and preview.samples > beyond_margin
expect forecast.from == 8 and forecast.seconds > 0
apply
wait settled
expect runs == 2 and phase == finished and alpha == 0.6 and compare.active == b
expect compare.common >= 8 and certified == on and preview.samples == nan
other-run
wait settled
expect compare.active == a and step == 8 and alpha == 0.2
quit
)",
                   "gallery:sphere --tolerance 12%") == 0);
}

TEST_CASE("a failed expectation ends the script with status 1") {
  CHECK(run_window("failing", "wait settled\nexpect bad_samples == 17\nquit\n") == 1);
  CHECK(run_window("unknown", "frobnicate\n") == 2);
}

TEST_CASE("a script does not wait for ever for what never comes") {
  const std::string said = (results / "impatient.out").string();
  CHECK(run_window("impatient", "wait settled\nwait until bad_samples == 17 within 0.5\nquit\n",
                   "gallery:sphere --tolerance 12% 2>" + said) == 1);
  std::ifstream in(said);
  const std::string words{std::istreambuf_iterator<char>(in), {}};
  CHECK(words.find("Line 3 (wait): \"bad_samples == 17\" did not hold within 0.5 s: bad_samples is 0") !=
        std::string::npos);
  CHECK(run_window("patient", "wait until bad_samples == 0 within 100\nquit\n") == 0);
  CHECK(run_window("no-time", "wait until bad_samples == 0 within spring\nquit\n") == 1);
}

TEST_CASE("a scripted mouse turns, picks and zooms") {
  CHECK(run_window("mouse", R"(
wait settled
look z
expect heading == 0
drag 560 300 660 320
expect heading != 0
click 600 300
expect selection != none
wheel 600 300 3
key Esc
expect selection == none
quit
)") == 0);
}

TEST_CASE("Ω is drawn in finer voxels where the camera is near, and only there") {
  CHECK(run_window("near",
                   R"(
wait settled
expect omega.voxels > 4 and omega.voxels < 8 and omega.coarse == off and omega.near.voxels == none
look z
wheel 620 290 20
wait settled
expect omega.near.voxels > 10 and omega.near.megabytes < 64
screenshot )" + picture("near") +
                       R"(
frame-all
wait settled
expect omega.near.voxels == none
quit
)",
                   "gallery:sphere --tolerance 0.6% --sigma 0.95 --paused") == 0);
}

TEST_CASE("pictures look as they should") {
  const std::string script = "wait settled\nseek 12\nscreenshot " + picture("scene") +
                             "\nset clip plane\nsplit\ntab plots\nscreenshot " + picture("split") +
                             "\nscene\npick tet 30\ntab timeline\ntheme light\nscreenshot " +
                             picture("inspector") +
                             "\ntheme dark\ngallery\nwait until gallery.ready == on\nwait 1\nscreenshot " +
                             picture("gallery") + "\nquit\n";
  REQUIRE(run_window("pictures", script) == 0);
  for (const char* name : {"scene", "split", "inspector", "gallery"}) compare(name);
}

TEST_CASE("a whole run is watched through its stages, and edges are asked why they stayed") {
  CHECK(run_window("stages", R"(
wait settled
expect phase == finished and certified == on and form == free
expect count.collapse > 100 and count.insertion > 100
stage gamma
expect state_step == begin.gamma and form == interpolated
stage tessellation
expect form == interpolated
step
expect form == embedded and stage == tessellation and facets_added > 100
stage zero-set
next-event collapse
expect event.kind == collapse and selection == edge and facets_removed > 0 and vertices_moved > 0
expect xray.verdict == possible and xray.agrees == on and xray.kernel_radius > 0
set moment before
expect moment == before
set moment both
blink
wait 1
blink
expect moment == both
next-event rejection outside-tolerance zero-set
expect event.kind == rejection and event.reason == outside-tolerance and selection == edge
expect event.value > event.limit and xray.agrees == on and xray.verdict == outside-tolerance
expect xray.containment == failed and xray.link == passed and xray.kernel == passed
expect xray.kernel_faces >= 4 and xray.recorded >= 1 and xray.candidates == failed
witness
next-event rejection
previous-event rejection
expect event.kind == rejection
next-event link-condition
expect xray.offenders > 0 and xray.link == failed
set xray.target general
expect xray.halfedge == off
set xray.target automatic
filter rejection zero-set
next-event
expect event.kind == rejection
filter
clear
expect xray.verdict == none and event.kind == none
stage improve
step
expect form == free
pick facet 0
expect selection == facet
tab plots
set plots.over seconds
stage all
expect state_step == begin.all
quit
)",
                   "gallery:bracket --effort 1") == 0);
}

TEST_CASE("stages are left out and ended early as asked") {
  CHECK(run_window("short", R"(
wait settled
expect form == embedded and phase == finished and certified == on
expect begin.gamma == nan and begin.all == nan
set until improve
restart
wait settled
expect form == free
quit
)",
                   "gallery:sphere --tolerance 12% --until zero-set --skip gamma") == 0);
}

TEST_CASE("a held run goes on until a stage begins") {
  CHECK(run_window("until-stage", R"(
open gallery:sphere paused
wait settled
stage zero-set
wait settled
expect phase == paused and form == embedded
hold
wait settled
expect phase == finished
quit
)") == 0);
}

TEST_CASE("the X-ray and the plots look as they should") {
  const std::string script =
      "wait settled\nstage zero-set\nnext-event collapse zero-set\nscreenshot " + picture("xray") +
      "\nclear\nframe-all\nset clip plane\nset tets.all on\nsplit\ntab plots\nscreenshot " +
      picture("sides") + "\nquit\n";
  REQUIRE(run_window("edge-pictures", script) == 0);
  for (const char* name : {"xray", "sides"}) compare(name);
}

TEST_CASE("a real mouse and keyboard drive the window" * doctest::test_suite("xdotool")) {
  if (exit_of("command -v xdotool >/dev/null") != 0) {
    MESSAGE("SKIPPED: xdotool is not there.");
    return;
  }
  const std::string ready = picture("ready");
  fs::remove(ready);
  const std::string script = "wait settled\nlook z\nseek 5\nscreenshot " + ready + R"(
hands 12
expect step == 7
expect heading != 0
expect selection != none
quit
)";
  const std::string hands =
      "while [ ! -e " + ready +
      " ]; do sleep 0.1; done; sleep 1; xdotool mousemove 560 300 mousedown 1; for i in 1 2 3 4 5 6; do "
      "xdotool mousemove_relative 15 3; sleep 0.05; done; "
      "xdotool mouseup 1; xdotool key Right; sleep 0.2; xdotool key Right; sleep 0.2; "
      "xdotool mousemove 600 300 click 1";
  CHECK(run_window("hands", script, "gallery:sphere --tolerance 12%", hands) == 0);
}

TEST_CASE("the keyboard alone goes through the panes, and gives the keys back" *
          doctest::test_suite("xdotool")) {
  if (exit_of("command -v xdotool >/dev/null") != 0) {
    MESSAGE("SKIPPED: xdotool is not there.");
    return;
  }
  const std::string ready = picture("keys-ready"), script = "wait settled\nseek 5\nscreenshot " + ready + R"(
hands 10
expect step == 5 and keys == right and pane-bottom == on and layer.outer == off
key F6
expect keys == bottom
key F6
expect keys == none
key Shift+F6
expect keys == bottom
pane-bottom
wait 0.2
expect keys == none
key F6
expect keys == left
key Esc
expect keys == none
key Right
expect step == 6
quit
)";
  fs::remove(ready);
  // The eye of Ω's outer boundary is the second thing in the left pane, after the fold of the layers.
  const std::string hands = "while [ ! -e " + ready +
                            " ]; do sleep 0.1; done; sleep 1; for k in F6 Right Down Return F6 Right; do "
                            "xdotool key $k; sleep 0.4; done";
  CHECK(run_window("keys", script, "gallery:sphere --tolerance 12%", hands) == 0);
}

TEST_CASE("Alt with a letter opens a menu, and the help finds what is typed" *
          doctest::test_suite("xdotool")) {
  if (exit_of("command -v xdotool >/dev/null") != 0) {
    MESSAGE("SKIPPED: xdotool is not there.");
    return;
  }
  const std::string ready = picture("alt-ready"), script = "wait settled\nscreenshot " + ready + R"(
hands 8
expect-words No candidate lies where the whole one-ring is seen
expect-no-words Goes N operations on
clear
hands 6
expect menu == View
quit
)";
  fs::remove(ready);
  const std::string hands =
      "while [ ! -e " + ready +
      " ]; do sleep 0.1; done; sleep 1; xdotool key F1; sleep 1; xdotool mousemove 260 134 "
      "click 1; sleep 1; xdotool type candidate; sleep 6; xdotool key alt+v";
  CHECK(run_window("alt", script, "gallery:sphere --tolerance 12% --size 1280x800", hands) == 0);
}

TEST_CASE("without a display there is a clear word and status 2") {
  fs::create_directories(results);
  const fs::path words = results / "no-display.txt";
  CHECK(exit_of("env -u DISPLAY -u WAYLAND_DISPLAY " + std::string(ISOSCOPE_PROGRAM) + " 2> " +
                words.string()) == 2);
  std::ifstream in(words);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  CHECK(text.find("display") != std::string::npos);
  CHECK(text.find("isoscope-run") != std::string::npos);
}

TEST_CASE("wrong options are refused without a window") {
  CHECK(exit_of(std::string(ISOSCOPE_PROGRAM) + " --size 10 2>/dev/null") == 2);
  CHECK(exit_of(std::string(ISOSCOPE_PROGRAM) + " --alpha 7 2>/dev/null") == 2);
  CHECK(exit_of(std::string(ISOSCOPE_PROGRAM) + " --until never 2>/dev/null") == 2);
  CHECK(exit_of(std::string(ISOSCOPE_PROGRAM) + " --help >/dev/null") == 0);
}
