// Every lesson in the real window, from its first stop to its last: each command finds what it looks for,
// what is said to be right holds, and what is to be done can be done.
#include "lesson/lesson.h"
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

using namespace isoscope;
using isoscope::test::run_window;

namespace fs = std::filesystem;

namespace {

/// What does a thing to do, at a stop of a lesson.
struct Solution {
  std::string_view lesson, stop, commands;
};
constexpr std::array<Solution, 17> solutions{{
    {"classification", "Your turn", "pick-worst\n"},
    {"refinement", "Enough", "stage refinement\nstep 3\n"},
    {"misoriented", "Find the others", "next-violation misoriented\n"},
    {"link-condition", "In T and in Z", "next-event link-condition\n"},
    {"kernel", "Dragging out of it", "what-if 100 100 100\n"},
    {"targets", "The others", "next-candidate\nnext-candidate\nnext-candidate\n"},
    {"invalid-region", "And those that cost too much", "set xray.target automatic\n"},
    {"tessellation", "Quads", "back\n"},
    {"edges-of-z", "Moving it", "nudge-right\n"},
    {"searching-in-the-kernel", "Walk them", "next-candidate\n"},
    {"making-room", "And again", "stage all\nnext-event collapse all\n"},
    {"boundaries", "The cut", "set layer.dropped on\n"},
    {"boundaries", "Keep or fill", "hole all fill\n"},
    {"noise", "Which δ?", "set preview_delta most\n"},
    {"parameters", "More margin", "set alpha 0.5\n"},
    {"topology-breaks", "Small enough", "set tolerance 6%\nrestart\nwait settled\nend\ntopology\n"},
    {"why-a-collapse-failed", "Would another target do?", "what-if 100 100 100\n"},
}};

/// What goes through a lesson; what is to be done at a stop is done by commands.
enum class By { mouse, keys, both };

/// Goes on by a button, whose label is given, or by its key.
std::string press(bool mouse, const std::string& label, const std::string& key) {
  return mouse ? "click-words " + label + "\n" : "key " + key + "\n";
}

/// An answer may be longer than its line: its first words.
std::string first_words(const std::string& answer) {
  return answer.substr(0, answer.find(' ', 14));
}

/// The commands of a lesson that is on: wrong at the first question, right at all others; what is to be done
/// is done, after the first look at its hint. By both: one stop by the mouse, the next one by keys.
std::string walk(const Lesson& lesson, By by) {
  std::string script;
  bool wrong = true, hinted = false, mouse = by != By::keys;
  std::size_t right_ones = 0;
  for (std::size_t i = 0; i < lesson.stops.size(); ++i) {
    const LessonStop& stop = lesson.stops[i];
    if (by == By::both) mouse = i % 2 == 0;
    script += "wait answers\nexpect lesson.error == none and lesson.stop == " + std::to_string(i + 1) + "\n";
    if (stop.question) {
      const std::size_t right = stop.question->right();
      const std::size_t guess = wrong ? (right + 1) % stop.question->answers.size() : right;
      right_ones += wrong ? 0 : 1;
      script += "expect lesson.phase == asking\nexpect-words Skip\n" +
                press(mouse, first_words(stop.question->answers[guess].text), std::to_string(guess + 1)) +
                "wait answers\nexpect lesson.error == none and lesson.phase == reading and lesson.right == " +
                std::to_string(right_ones) + "\nexpect-words " + (wrong ? "No: it is answer " : "Yes.") +
                "\n";
      wrong = false;
    } else if (stop.task) {
      const auto solution = std::find_if(solutions.begin(), solutions.end(), [&](const Solution& s) {
        return s.lesson == lesson.name && s.stop == stop.heading;
      });
      CHECK_MESSAGE(solution != solutions.end(), stop.heading);
      script += "expect lesson.phase == trying and lesson.done == off and lesson.hint == off\n";
      if (!std::exchange(hinted, true))
        script +=
            (mouse ? "click-words Hint\n" : "lesson-hint\n") + std::string("expect lesson.hint == on\n");
      if (solution != solutions.end())
        script += std::string(solution->commands) +
                  "wait answers\nexpect lesson.done == on and lesson.phase == reading\nwait 0.1\n";
    } else {
      script += "expect lesson.phase == reading\n";
    }
    script += press(mouse, i + 1 == lesson.stops.size() ? "Finish" : "Next", "Enter");
  }
  return script + "wait answers\nexpect lesson.phase == finished\nexpect-words The end\n" +
         press(by != By::keys, "Leave", "Ctrl+Shift+L") + "wait 0.2\nexpect lesson.phase == off\n";
}

/// Goes through every so manyth lesson from the `first` on.
void walk_through(By by, std::size_t first, std::size_t every) {
  const auto& lessons = bundled_lessons();
  REQUIRE(lessons.ok());
  for (std::size_t i = first; i < lessons->size(); i += every) {
    const Lesson& lesson = (*lessons)[i];
    CAPTURE(lesson.name);
    CHECK(run_window("lesson-" + lesson.name, walk(lesson, by) + "quit\n",
                     "lesson:" + lesson.name + " --size 900x640") == 0);
  }
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("every odd lesson can be gone through by mouse and keys, and what it says holds") {
  walk_through(By::both, 0, 2);
}

TEST_CASE("every even lesson can be gone through by mouse and keys, and what it says holds" *
          doctest::test_suite("even")) {
  walk_through(By::both, 1, 2);
}

TEST_CASE("every lesson is gone through by the mouse alone" * doctest::test_suite("soak")) {
  walk_through(By::mouse, 0, 1);
}

TEST_CASE("every lesson is gone through by keys alone" * doctest::test_suite("soak")) {
  walk_through(By::keys, 0, 1);
}

TEST_CASE(
    "a lesson gives back what it found, is gone through by keys, and is never remembered as the layout") {
  CHECK(run_window("lesson-keys", R"(
wait settled
look z
set clip plane
set layer.inner off
filter +reject
pane-left
section
expect pane-left == off and pane-left.kept == off and pane-bottom == on and heading == 0
key Ctrl+L
expect overlay == lessons
lesson tessellation
wait answers
expect lesson.phase == reading and lesson.stop == 1 and clip == none and layer.inner == on
expect pane-left == off and pane-right == off and pane-bottom == off
expect pane-right.kept == on and pane-bottom.kept == on
key Enter
wait answers
expect lesson.stop == 2 and lesson.phase == asking
key 2
wait answers
expect lesson.phase == reading and lesson.right == 1
key PageDown
wait answers
expect lesson.stop == 3
key Backspace
wait answers
expect lesson.stop == 2
key P
expect presenter == on
key Enter
wait answers
expect lesson.stop == 3 and presenter == on
key Esc
expect presenter == off and lesson.phase == reading
pane-bottom
expect pane-bottom == on
lesson-end
expect lesson.phase == off and pane-left == off and pane-right == on and pane-bottom == on
expect clip == plane and layer.inner == off and heading == 0 and mode == section
expect pane-left.kept == off and pane-right.kept == on
lesson tessellation
wait answers
reset-layout
expect pane-left == on and pane-left.kept == on
lesson-end
expect pane-left == on and pane-right == on and pane-bottom == on
quit
)",
                   "gallery:sphere --tolerance 12% --until refinement --size 900x600") == 0);
}

TEST_CASE("the first stop of a lesson shows its whole model, whatever was open before") {
  const std::string script = R"(
lesson whole-way
wait settled
expect lesson.stop == 1 and filled > 0.5 and filled < 1.7
lesson-next
wait answers
expect lesson.stop == 2 and filled > 0.5 and filled < 1.7
quit
)";
  CHECK(run_window("lesson-first-model", script, "--size 640x400") == 0);
  CHECK(run_window("lesson-after-another", "wait settled\nlook z\n" + script,
                   "gallery:sphere --tolerance 12% --until refinement --size 640x400") == 0);
}

TEST_CASE("a lesson is gone through by the mouse") {
  CHECK(run_window("lesson-mouse", R"(
wait settled
expect lesson.stop == 1 and lesson.phase == reading
click 190 556
wait answers
expect lesson.stop == 2 and lesson.phase == asking
click 60 556
wait answers
expect lesson.stop == 1
quit
)",
                   "lesson:tessellation --size 900x600") == 0);
}

TEST_CASE("the last stop on parameters makes its second run where it was begun with") {
  CHECK(run_window("lesson-last-stop", R"(
lesson parameters 5
wait answers
expect lesson.error == none and lesson.phase == reading and lesson.stop == 5
expect runs == 2 and compare.beside == on and alpha == 0.2
expect-words First differing decision
key Backspace
wait answers
expect lesson.error == none and lesson.stop == 4 and runs == 2
quit
)",
                   "--size 1000x700") == 0);
}

TEST_CASE("what is said of an answer comes into sight, and inspectors begin at the top of each stop") {
  CHECK(run_window("lesson-in-sight", R"(
lesson parameters 3
wait answers
expect lesson.stop == 3
lesson-answer right
wait answers
wait 0.2
expect-words Yes.
expect-words its number goes with
lesson making-room 2
wait answers
lesson-answer right
wait answers
wait 1.5
expect-words neighbours tried
lesson-next
wait answers
expect lesson.stop == 3 and inspector.scroll == 0
quit
)",
                   "--size 1000x700") == 0);
}

TEST_CASE("a lesson is written as pages") {
  const fs::path folder = fs::path(ISOSCOPE_RESULTS) / "pages";
  fs::remove_all(folder);
  CHECK(run_window("lesson-pages", "wait settled\nlesson-pages tessellation " + folder.string() + R"( 320x200
wait answers
expect lesson.phase == off and export.error == none
quit
)",
                   "gallery:sphere --tolerance 12% --until refinement --size 640x400") == 0);
  const std::string markdown = text_of(folder / "lesson.md"), html = text_of(folder / "lesson.html");
  const Lesson* lesson = find_lesson("tessellation");
  REQUIRE(lesson != nullptr);
  for (std::size_t i = 0; i < lesson->stops.size(); ++i) {
    const std::string picture = "0" + std::to_string(i + 1) + ".png";
    CHECK(fs::file_size(folder / picture) > 1000);
    CHECK(markdown.find("## " + lesson->stops[i].heading) != std::string::npos);
    CHECK(markdown.find(picture) != std::string::npos);
    CHECK(html.find(picture) != std::string::npos);
  }
  CHECK(markdown.find("Answer 2.") != std::string::npos);
  CHECK(markdown.find("*Try:*") != std::string::npos);
  CHECK(markdown.find('{') == std::string::npos); // values stand where their names were
}
