// What section after section says is in sight can be read there: verdicts, points outside the kernel, what
// held before an operation, ranges, warnings, numbers beside their limits.
#include "platform/image_file.h"
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <filesystem>

using namespace isoscope;
using namespace isoscope::test;
namespace fs = std::filesystem;

namespace {

const std::string wide = "gallery:bracket --effort 0 --size 1280x800";

std::string result_file(const char* name) {
  return (fs::path(ISOSCOPE_RESULTS) / name).string();
}

} // namespace

TEST_CASE("what can collapse now never stands over what the journal says without a word of whose it is") {
  CHECK(run_window("whose-verdict", R"(
wait settled
stage zero-set
next-event rejection outside-tolerance zero-set
wait answers
expect xray.agrees == on and xray.verdict == outside-tolerance
expect-words stays: outside Ω
expect-words the journal says the same, numbers and all
expect-no-words could collapse
# The distance is not told as the limit that it exceeds.
expect event.value > event.limit
expect-no-words d = 1.000 δ (limit 1.000 δ)
set xray.target general
wait answers
expect xray.verdict == possible
expect-words now: could collapse
expect-words judged now with other targets; the journal's own decision stands below
expect-words The journal's decision
expect-words stays: Z would leave Ω
set xray.target automatic
what-if optimum
wait answers
wait 1
# The verdict stays in sight above what was scrolled to.
expect answer == what-if and inspector.scroll > 0
expect-words What if the target were elsewhere?
expect-words Edge 822 – 931 stays: outside Ω
quit
)",
                   wide) == 0);
}

TEST_CASE("points outside the kernel are named with their distance, and drawn") {
  const std::string with = result_file("outside-drawn.png"), without = result_file("outside-hidden.png");
  CHECK(run_window("outside-kernel", R"(
wait settled
stage zero-set
next-event rejection no-candidate
wait answers
expect event.reason == no-candidate and xray.outside >= 1 and xray.kernel_faces > 3
expect-words Outside the kernel
expect-words which stays
expect-words outside
picture )" + with + R"( 400x300
set layer.xray off
picture )" + without + R"( 400x300
quit
)",
                   wide) == 0);
  const auto a = read_png(with), b = read_png(without);
  REQUIRE(a.ok());
  REQUIRE(b.ok());
  std::size_t differ = 0;
  for (std::size_t i = 0; i < a->pixels.size(); i += 4) differ += a->pixels[i] != b->pixels[i] ? 1 : 0;
  CHECK(differ > 300);
}

TEST_CASE("of a sample that went in the inspector says what held before") {
  CHECK(run_window("before-operation", R"(
wait settled
seek 30
wait answers
pick-operation
wait answers
expect selection == sample and sample.error < 1
expect-words Before this operation
expect-words After it: a vertex of T
expect-words bad: f had the wrong sign here
quit
)",
                   "gallery:bracket --until refinement --size 1280x800") == 0);
}

TEST_CASE("a range counts reasons, and the list keeps to the play head under a filter") {
  CHECK(run_window("range-and-filter", R"(
wait settled
tab work
range 10 40
wait answers
expect-words range: 10–40
expect-words 31 ×
expect work.decisions == 31
range
stage zero-set
tab events
filter rejection zero-set
next-event
wait answers
expect event.kind == rejection and event.step >= begin.zero-set
seek 900
next-event
wait answers
expect event.kind == rejection and event.step >= 900
filter
sort-events ms
wait answers
expect-words ms
quit
)",
                   wide) == 0);
}

TEST_CASE("bad samples beside a certificate are explained, and asked samples are not excused") {
  CHECK(run_window("bad-samples", R"(
wait settled
expect certified == on and bad_samples > 0
expect-words Certified
expect-words bad samples
expect-words Samples lie at 0.95 δ
expect-words is in Ω all the same
seek 30
wait answers
expect bad_samples > 0
expect-no-words Samples lie at
quit
)",
                   "gallery:bracket --until all --size 1280x1000") == 0);
}

TEST_CASE("that Ω is no thickening is in sight, in a narrow window too") {
  for (const char* size : {"1280x800", "700x480"})
    CHECK(run_window(
              "no-thickening", R"(
wait settled
expect thickening == off and warnings >= 1
expect-words Ω is no thickening
warnings
expect warnings.shown == on
expect-words Whether the volume is a thickening at this tolerance could not be told
quit
)",
              std::string("gallery:bracket --tolerance 7% --topology separate --until refinement --size ") +
                  size) == 0);
}

TEST_CASE("numbers under the sliders, Apply and Restart stay in sight; wrong ones are told there") {
  for (const char* size : {"1280x800", "1000x700", "700x480"})
    CHECK(run_window("parameters-in-sight", R"(
wait settled
seek 10
wait answers
expect-words 0.20
expect-words 0.500 δ
expect-words misoriented
expect-words Restart
set alpha 0.5
wait answers
expect preview.samples > 0 and forecast.seconds > 0
expect-words Apply branches at step 10.
expect-words from here
type alpha 2
wait answers
expect-words α is 2, which is not in (0, 1).
expect apply.would == wrong
type alpha 0.2
end
set alpha 0.4
wait answers
expect apply.would == too-late
expect-words α matters until the refinement ends
expect-words Restart
quit
)",
                     std::string("gallery:sphere --tolerance 12% --size ") + size) == 0);
}

TEST_CASE(
    "messages are not repeated and never lie on a slide; what is left out of a narrow window is counted") {
  const std::string file = result_file("alike.isorun");
  CHECK(run_window("messages", "record " + file + R"(
wait settled
wait until recording.whole == on
open-beside )" + file + R"(
wait settled
expect compare.same == on
dismiss
first-difference
first-difference
first-difference
expect messages == 1
expect-words (3 times)
presenter
expect presenter == on
expect-no-words (3 times)
clear
dismiss
expect messages == 0
close-other
expect-words stages
expect-words more
quit
)",
                   "gallery:sphere --tolerance 12% --size 700x480") == 0);
}

TEST_CASE("two runs keep timeline and inspector, and the table tells what B has more") {
  CHECK(run_window("two-runs-table", R"(
wait settled
set alpha 0.5
run-beside
wait settled
end
wait settled
expect compare.beside == on and pane-right == on and pane-bottom == on
expect-words vertices of Z
expect-words Δ
expect-words First differing decision
tab timeline
expect-words 1 classification
# Another model in the place of one of them is a new pair; the camera goes to it, and stays where runs change.
seek 3
wait settled
pick-worst
frame
wait settled
expect filled > 1.2
tab compare
open gallery:torus
wait settled
wait 0.3
expect filled < 1 and runs == 2 and compare.beside == on
frame
wait settled
other-run
wait settled
wait 0.3
other-run
wait settled
quit
)",
                   "gallery:sphere --tolerance 12% --size 1440x900") == 0);
}

TEST_CASE("layouts that are shown for a while are not kept, and reset-layout brings back the first one") {
  CHECK(run_window("layouts", R"(
wait settled
pane-bottom
expect pane-bottom == off and pane-bottom.kept == off
presenter
expect presenter == on and pane-left.kept == on and pane-right.kept == on
clear
expect presenter == off and pane-left == on
set alpha 0.5
run-beside
wait settled
expect pane-left == off and pane-left.kept == on
reset-layout
expect pane-bottom == on and pane-left == on
close-other
expect pane-left == on and pane-right == on and pane-bottom == on and pane-bottom.kept == on
quit
)",
                   "gallery:sphere --tolerance 12% --until refinement --size 1000x700") == 0);
}

TEST_CASE("the help has sections that a click goes to, and menus open in narrow windows too") {
  CHECK(run_window("help-sections", R"(
wait settled
help
wait 0.2
expect-words Goes N operations on
expect-no-words No point sees the whole one-ring
click-words Reasons
wait 0.2
expect-words No point sees the whole one-ring
expect-words Lk(a) ∩ Lk(b)
clear
palette
wait 0.2
expect-words a command, an event, an element, a setting, a lesson
clear
menu View
wait 0.2
expect-words Frame everything
quit
)",
                   "gallery:sphere --tolerance 12% --until refinement --size 1280x800") == 0);
  CHECK(run_window("narrow-menus", R"(
wait settled
menu View
wait 0.2
expect menu == View
expect-words Frame everything
quit
)",
                   "gallery:sphere --tolerance 12% --until refinement --size 700x480") == 0);
}
