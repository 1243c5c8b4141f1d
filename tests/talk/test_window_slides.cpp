// Talks in the real window: bookmarks as slides, undo of the view, the presenter mode.
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

using isoscope::test::run_window;

namespace fs = std::filesystem;

namespace {

const fs::path results = ISOSCOPE_RESULTS;

const std::string small = "gallery:sphere --tolerance 12% --until refinement";

} // namespace

TEST_CASE("bookmarks are made, turned as slides, ordered, written and read again") {
  const std::string sidecar = (results / "talk.json").string();
  fs::create_directories(results);
  fs::remove(sidecar);
  CHECK(run_window("slides", R"(
wait settled
expect bookmarks.count == 0 and bookmark == 0 and bookmark.step == nan
seek 3
look z
set clip plane
bookmark "where it starts"
seek 7
look x
set clip none
pick-worst
bookmark the worst sample
seek 11
clear
bookmark
expect bookmarks.count == 3 and bookmark == 3 and bookmark.step == 11
key Ctrl+1
expect bookmark == 1 and state_step == 3 and clip == plane and heading == 0 and selection == none
expect bookmark.note == "where it starts"
key PageDown
expect bookmark == 2 and state_step == 7 and clip == none and selection == sample and heading != 0
expect bookmark.note == "the worst sample"
key PageDown
key PageDown
expect bookmark == 3 and state_step == 11 and selection == none
key PageUp
expect bookmark == 2 and state_step == 7
bookmark-move 2 1
expect bookmark == 1 and bookmark.step == 7
bookmark-note 3 the end
bookmarks save )" + sidecar + R"(
bookmark-delete 1
expect bookmarks.count == 2 and bookmark == 0
bookmarks load )" + sidecar + R"(
expect bookmarks.count == 3 and bookmark == 0
key Ctrl+3
expect bookmark.step == 11 and bookmark.note == "the end" and state_step == 11
restart
wait settled
expect bookmarks.count == 0
quit
)",
                   small) == 0);
  CHECK(fs::file_size(sidecar) > 500);
  CHECK(run_window("slides-missing", "wait settled\nbookmark-go 1\n", small + " 2>/dev/null") == 1);
  CHECK(run_window("slides-damaged", "wait settled\nbookmarks load /dev/null\n", small + " 2>/dev/null") ==
        1);
}

TEST_CASE("view, filter, selection and layout are undone and redone; the run is not") {
  CHECK(run_window("undo", R"(
wait settled
seek 5
expect undo.depth == 0 and redo.depth == 0
set clip plane
expect undo.depth == 1
look z
filter rejection
pick-worst
key Ctrl+Shift+1
expect undo.depth == 5 and selection == sample and heading == 0
key Ctrl+Z
key Ctrl+Z
expect selection == none and undo.depth == 3 and redo.depth == 2 and step == 5
undo
undo
expect heading != 0 and clip == plane
undo
expect clip == none and undo.depth == 0 and redo.depth == 5
key Ctrl+Y
key Ctrl+Shift+Z
expect clip == plane and heading == 0 and redo.depth == 3
drag 560 300 660 320
expect heading != 0 and undo.depth == 3 and redo.depth == 0
undo
expect heading == 0 and undo.depth == 2 and step == 5
seek 8
expect undo.depth == 2 and redo.depth == 1
quit
)",
                   small) == 0);
}

TEST_CASE("the presenter mode says what happens and why, at the speed asked for, and Esc ends it") {
  CHECK(run_window("presenter", R"(
wait settled
expect presenter == off and slow_down == on and moments >= 12 and moment.told == 0
seek 1
key P
expect presenter == on
expect caption != none and caption.why != none and caption.figure == "Figure 1"
speed 64
expect speed == 64
key ,
expect speed == 32
key .
key .
expect speed == 128
speed 0.25
key ,
expect speed == 0
speed 8
play
wait 2
expect step >= 2 and step <= 4 and moment.told > 0
play
expect moment.told > 0
seek 0
expect moment.told == 0 and caption == "samples on both boundaries of Ω, before there is a T"
expect caption.why == "Both boundaries of Ω have their samples; T comes next, as a box around them."
step
expect caption == "set-up: T begins as a box around the samples"
expect caption.why == "f is positive at all corners: there is no Z yet, and all samples inside are wrong."
seek 0
key PageDown
expect moment.told == 1 and state_step == 0 and caption != "samples on both boundaries of Ω, before there is a T"
seek 12
expect moment.told == 0
key PageUp
expect moment.told > 1 and state_step < 12 and state_step > 0
slow-down
expect slow_down == off
speed 64
play
wait 0.5
expect step == steps
key P
expect presenter == off
key P
pick-worst
key Esc
expect presenter == off and selection == sample
key Esc
expect selection == none
quit
)",
                   small) == 0);
}

TEST_CASE("a whole run has its moments, each with what it is about; what is alike is summed up") {
  CHECK(run_window("moments", R"(
wait settled
expect moments >= 30
first
next-slide
expect moment.told == 1
stage zero-set
next-event rejection outside-tolerance
expect caption == "simplifying Z: an edge stays: Z would leave the tolerance"
expect caption.why == "Here δ decides: a larger tolerance would let this edge go."
next-event link-condition
expect caption == "simplifying Z: an edge stays: collapsing it would pinch the triangulation"
expect caption.figure == "Figure 6"
clear
stage gamma
next-slide
next-slide
expect moment.told > 10 and stage == gamma
expect selection == edge
previous-slide
stage zero-set
step 12
clear
expect caption == "simplifying Z: 12 edges in a row have collapsed, Z has 444 vertices"
quit
)",
                   "gallery:bracket --effort 0 --tolerance 4%") == 0);
}
