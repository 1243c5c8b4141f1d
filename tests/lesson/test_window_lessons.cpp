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

/// The commands of a lesson that is on: wrong at the first question, right at all others; what is to be done
/// is done, after the first look at its hint.
std::string walk(const Lesson& lesson) {
  std::string script;
  bool wrong = true, hinted = false;
  for (std::size_t i = 0; i < lesson.stops.size(); ++i) {
    const LessonStop& stop = lesson.stops[i];
    script += "wait answers\nexpect lesson.error == none and lesson.stop == " + std::to_string(i + 1) + "\n";
    if (stop.question) {
      const std::size_t right = stop.question->right();
      const std::size_t guess = wrong ? (right + 1) % stop.question->answers.size() : right;
      wrong = false;
      script += "expect lesson.phase == asking\nlesson-answer " + std::to_string(guess + 1) +
                "\nwait answers\nexpect lesson.error == none and lesson.phase == reading\n";
    } else if (stop.task) {
      const auto solution = std::find_if(solutions.begin(), solutions.end(), [&](const Solution& s) {
        return s.lesson == lesson.name && s.stop == stop.heading;
      });
      CHECK_MESSAGE(solution != solutions.end(), stop.heading);
      script += "expect lesson.phase == trying and lesson.done == off and lesson.hint == off\n";
      if (!std::exchange(hinted, true)) script += "lesson-hint\nexpect lesson.hint == on\n";
      if (solution != solutions.end())
        script += std::string(solution->commands) +
                  "wait answers\nexpect lesson.done == on and lesson.phase == reading\n";
    } else {
      script += "expect lesson.phase == reading\n";
    }
    script += "lesson-next\n";
  }
  return script + "wait answers\nexpect lesson.phase == finished\nlesson-end\nexpect lesson.phase == off\n";
}

/// Goes through every second lesson from the `first` on.
void walk_every_second(std::size_t first) {
  const auto& lessons = bundled_lessons();
  REQUIRE(lessons.ok());
  for (std::size_t i = first; i < lessons->size(); i += 2) {
    const Lesson& lesson = (*lessons)[i];
    CAPTURE(lesson.name);
    CHECK(run_window("lesson-" + lesson.name, walk(lesson) + "quit\n",
                     "lesson:" + lesson.name + " --size 640x400") == 0);
  }
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("every odd lesson can be gone through, and what it says holds") {
  walk_every_second(0);
}

TEST_CASE("every even lesson can be gone through, and what it says holds" * doctest::test_suite("even")) {
  walk_every_second(1);
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

TEST_CASE("whole lessons are gone through by the mouse alone, and by keys alone") {
  for (const std::string name : {"tessellation", "classification"}) {
    const Lesson* lesson = find_lesson(name);
    REQUIRE(lesson != nullptr);
    std::string mouse = "wait settled\n", keys = mouse;
    std::size_t questions = 0;
    for (std::size_t i = 0; i < lesson->stops.size(); ++i) {
      const LessonStop& stop = lesson->stops[i];
      for (std::string* script : {&mouse, &keys})
        *script += "wait answers\nexpect lesson.stop == " + std::to_string(i + 1) + "\n";
      if (stop.question) {
        const std::size_t right = stop.question->right();
        // An answer may be longer than its line.
        const std::string& words = stop.question->answers[right].text;
        mouse += "click-words " + words.substr(0, words.find(' ', 14)) + "\n";
        keys += "key " + std::to_string(right + 1) + "\n";
        ++questions;
        for (std::string* script : {&mouse, &keys})
          *script += "wait answers\nexpect lesson.phase == reading and lesson.right == " +
                     std::to_string(questions) + "\nexpect-words Yes.\n";
      }
      const bool last = i + 1 == lesson->stops.size();
      mouse += std::string("click-words ") + (stop.task ? "Skip" : last ? "Finish" : "Next") + "\n";
      keys += "key Enter\n";
    }
    for (std::string* script : {&mouse, &keys})
      *script += "wait answers\nexpect lesson.phase == finished\nexpect-words The end\n";
    mouse += "click-words Leave\nwait 0.2\nexpect lesson.phase == off\nquit\n";
    keys += "lesson-end\nexpect lesson.phase == off\nquit\n";
    const std::string arguments = "lesson:" + name + " --size 1000x700";
    CAPTURE(name);
    CHECK(run_window("mouse-alone-" + name, mouse, arguments) == 0);
    CHECK(run_window("keys-alone-" + name, keys, arguments) == 0);
  }
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
