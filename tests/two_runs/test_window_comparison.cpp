// Two runs in the real window, by their numbers: question 18, what differs between two runs.
#include "platform/image_file.h"
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>

using isoscope::test::run_window;

namespace {

const std::filesystem::path results = ISOSCOPE_RESULTS;

} // namespace

TEST_CASE("two runs with another α differ first in a limit, then in a decision, and are linked") {
  CHECK(run_window("compare-alpha", R"(
wait settled
expect runs == 1 and compare.beside == off and compare.first_step == none and compare.b.steps == none
set alpha 0.5
run-beside
wait settled
expect runs == 2 and compare.beside == on and compare.active == a and alpha == 0.2
# Panes make room, but that is not what is remembered.
expect pane-left == off and pane-left.kept == on and pane-right.kept == on
# The inspector stays: there is room for it.
expect pane-right == on
expect compare.same == off and compare.parameters == 1 and compare.measure_event == 2
expect compare.a.certified == on and compare.b.certified == on
expect compare.first_event > 2 and compare.first_step > 1 and compare.only_a > 0 and compare.only_b > 0
# Before the first difference both play heads stand on the same step, and on the same Z.
seek 4
wait settled
expect compare.a.step == 4 and compare.b.step == 4 and compare.common > 4
# At the end of a stage both stand there.
stage gamma
wait settled
expect compare.a.step < compare.a.steps and compare.b.step > compare.common
end
wait settled
expect compare.a.vertices > 3 and compare.b.vertices > 3
first-difference
wait settled
expect compare.a.event == insertion and compare.b.event == insertion
expect compare.a.step >= compare.common and compare.b.step > compare.common and compare.row == none
next-difference
expect compare.row == 0
next-difference
previous-difference
expect compare.row == 0
difference 1
expect compare.row == 1
# The camera is one until it is not.
front
orthographic
link-cameras
frame-all
side-by-side
expect pane-left == on and pane-right == on
quit
)") == 0);
}

TEST_CASE("the other run's Z is drawn over this one's, also where it has no view of its own") {
  CHECK(run_window("both-z", R"(
wait settled
expect runs == 1 and layer.other-zero == off
set alpha 0.5
run-beside
wait settled
side-by-side
end
wait settled
expect compare.beside == off
picture )" + (results / "one-z.png").string() +
                                 R"( 400x300
both-z
wait settled
expect layer.other-zero == on
picture )" + (results / "both-z.png").string() +
                                 R"( 400x300
section
picture )" + (results / "both-z-section.png").string() +
                                 R"( 400x300
svg )" + (results / "both-z.svg").string() +
                                 R"(
both-z
picture )" + (results / "one-z-section.png").string() +
                                 R"( 400x300
both-z
scene
close-other
wait settled
picture )" + (results / "without-other.png").string() +
                                 R"( 400x300
quit
)") == 0);
  const auto lines = [](const char* name) {
    const auto image = isoscope::read_png(results / name);
    REQUIRE(image.ok());
    std::size_t count = 0; // green with little blue
    for (std::size_t i = 0; i + 3 < image->pixels.size(); i += 4)
      count +=
          image->pixels[i + 1] > image->pixels[i + 2] + 60 && image->pixels[i + 1] > image->pixels[i] + 20;
    return count;
  };
  CHECK(lines("both-z.png") > lines("one-z.png") + 300);
  CHECK(lines("without-other.png") < lines("both-z.png") / 4);
  CHECK(lines("both-z-section.png") > lines("one-z-section.png") + 300);
  std::ifstream figure(results / "both-z.svg");
  const std::string drawn{std::istreambuf_iterator<char>(figure), {}};
  CHECK(drawn.find("id=\"other-zero\"") != std::string::npos);
}

TEST_CASE("cameras and play heads are linked until somebody parts them") {
  CHECK(run_window("compare-links", R"(
wait settled
set sigma 0.3
key Ctrl+Shift+Enter
wait settled
expect compare.first_event == 2 and compare.first_step == 1 and compare.common == 1
expect compare.b.steps > 1 and compare.parameters == 1
seek 5
wait settled
expect compare.a.distance == compare.b.distance
link-cameras
pick-worst
frame
wait settled
expect compare.a.distance < compare.b.distance
link-cameras
expect compare.a.distance == compare.b.distance
link-steps
seek 3
wait settled
expect compare.a.step == 3 and compare.b.step > 3
link-steps
wait settled
seek 0
wait settled
expect compare.a.step == 0 and compare.b.step == 0
# Tab makes the other run the active one; both keep their places.
key Tab
expect compare.active == b and compare.a.step == 0 and compare.b.step == 0
seek 3
wait settled
expect compare.b.step == 3 and compare.a.step > 0
key Tab
expect compare.active == a and compare.b.step == 3
# Hidden it stays, closed it goes.
key B
expect compare.beside == off and runs == 2
key B
wait settled
expect compare.beside == on
close-other
expect compare.beside == off and runs == 1
quit
)") == 0);
}

TEST_CASE("a recording opens beside a run, and the same run does not differ from it") {
  const std::string file = std::string(ISOSCOPE_RESULTS) + "/beside.isorun";
  CHECK(run_window("compare-recording", "record " + file + R"(
wait settled
wait until recording.whole == on
open-beside )" + file + R"(
wait settled
expect runs == 2 and compare.same == on and compare.parameters == 0 and compare.first_step == none
seek 20
wait settled
expect compare.a.step == 20 and compare.b.step == 20
first-difference
expect messages > 0
quit
)") == 0);
}

TEST_CASE("a branch is compared with what it left") {
  CHECK(run_window("compare-branch", R"(
wait settled
stage zero-set
next-event collapse zero-set
what-if
nudge-right
expect what-if.verdict == possible
do-it
wait settled
expect branched == on and compare.active == b and compare.beside == off
side-by-side
wait settled
expect compare.beside == on and compare.parameters == 0 and compare.same == off
first-difference
wait settled
expect compare.a.event == collapse and compare.b.event == collapse and compare.a.step == compare.b.step
expect event.reason == user
other-run
wait settled
expect branched == off and compare.active == a
quit
)",
                   "gallery:bracket --size 1440x900 --effort 0") == 0);
}

TEST_CASE("a run begun again while the table compares it with another has no answers about the one before") {
  CHECK(run_window("compare-begun-again", R"(
wait settled
set alpha 0.5
wait settled
apply-earlier
wait settled
tab compare
wait settled
expect runs == 2 and compare.common > 0
set tolerance 10%
restart
wait 0.3
set tolerance 9%
restart
wait settled
expect runs == 2 and phase == finished
set tolerance 12%
restart
wait 0.1
other-run
wait 0.1
other-run
restart
wait settled
expect phase == finished
quit
)",
                   "gallery:sphere --tolerance 12%") == 0);
}
