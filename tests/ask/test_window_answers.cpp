// Answers are in sight: warnings, sections through what is selected, maps of Z, lanes and orders of events,
// the palette.
#include "platform/image_file.h"
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace isoscope;
using namespace isoscope::test;
namespace fs = std::filesystem;

namespace {

std::string result(const char* name) {
  return (fs::path(ISOSCOPE_RESULTS) / name).string();
}

std::string text_of(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("answers come into sight, and a new selection begins at the top") {
  CHECK(run_window("answers-in-sight", R"(
wait settled
wait 0.1
expect thickening == on and answer == certificate
stage zero-set
next-event rejection
wait answers
expect selection == edge and inspector.scroll == 0
unlock
wait answers
wait 1
expect answer == unlock and inspector.scroll > 0
pick vertex 40
expect inspector.scroll == 0
topology
wait answers
wait 1
expect answer == topology
certificate
wait settled
wait 1
expect answer == certificate
quit
)") == 0);
}

TEST_CASE("what is not judged yet is no number, and warnings are counted") {
  CHECK(run_window("not-judged", R"(
wait settled
seek 4
wait settled
expect violating_3 >= 0 and violations.misoriented >= 0
pick sample 3
expect sample.error != none and sample.remedy != none
seek 0
wait settled
expect sample.error == none and sample.remedy == none and violations.flat == none and violating_2 == nan
warnings
expect warnings.shown == on
quit
)",
                   "gallery:noisy-sphere --until refinement") == 0);
}

TEST_CASE("the section passes through the selected edge, and its handle moves the plane") {
  const std::string figure = result("edge-section.svg");
  CHECK(run_window("section-through", R"(
wait settled
stage zero-set
next-event collapse zero-set
wait answers
expect xray.kernel_faces > 3
section-selection
expect mode == split and clip == plane
svg )" + figure + R"(
clear
scene
set clip plane
set clip.normal x
set clip.x 0
look z
drag-clip 60 0
expect clip.x > 0
set clip.handle off
set clip.x 0
drag-clip 60 0
expect clip.x == 0
quit
)") == 0);
  const std::string svg = text_of(figure);
  CHECK(svg.find("id=\"edge-kernel\"") != std::string::npos);
  CHECK(svg.find("id=\"edge-marks\"") != std::string::npos);
}

TEST_CASE("Z is coloured by maps, and pictures have their colour bar and legend") {
  const std::string plain = result("map-plain.png"), keyed = result("map-keyed.png");
  CHECK(run_window("maps", R"(
wait settled
picture )" + plain + R"( 320x240
colour-by distance
wait answers
expect colour-by == distance and map.largest > 0 and map.largest <= 1 and map.high == 1
colour-by normals
wait answers
expect map.largest > 0 and map.largest <= 90
colour-by valence
wait answers
expect map.least >= 3 and map.low == 3
colour-by age
wait answers
expect map.largest > 0
legend
expect legend == on
picture )" + keyed + R"( 320x240
colour-by none
expect map.largest == nan
quit
)") == 0);
  const auto a = read_png(plain), b = read_png(keyed);
  REQUIRE(a.ok());
  REQUIRE(b.ok());
  // The corner of the key differs, the opposite one does not.
  const auto same_at = [&](int x, int y) {
    const std::size_t i = 4 * (static_cast<std::size_t>(y) * 320 + static_cast<std::size_t>(x));
    return std::equal(a->pixels.begin() + static_cast<std::ptrdiff_t>(i),
                      a->pixels.begin() + static_cast<std::ptrdiff_t>(i) + 4,
                      b->pixels.begin() + static_cast<std::ptrdiff_t>(i));
  };
  CHECK(same_at(4, 4));
  CHECK(!same_at(300, 222));
}

TEST_CASE("a lane is a filter, and the list is sorted by its columns") {
  CHECK(run_window("lanes", R"(
wait settled
tab timeline
seek 0
lane collapse
expect lane == collapse
next-event
expect event.kind == collapse
lane-event classification 5
expect step < 40
lane collapse
expect lane == none
tab events
lane classification
sort-events value
expect events.sort == -value
seek 0
next-event
expect event.here == events.first
sort-events value
expect events.sort == value
sort-events
expect events.sort == step
lane classification
quit
)") == 0);
}

TEST_CASE("menus open by their name, one at a time, also in a narrow window") {
  for (const char* size : {"1280x800", "820x520"})
    CHECK(run_window("menus", R"(
wait settled
menu View
expect menu != none
menu Ask
expect menu != none
quit
)",
                     std::string("gallery:sphere --tolerance 12% --until refinement --size ") + size) == 0);
}
