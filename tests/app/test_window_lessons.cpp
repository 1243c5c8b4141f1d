// Every lesson in the real window, from its first stop to its last: each command finds what it looks for, and
// what is said to be right holds.
#include "app/window_script.h"
#include "lesson/lesson.h"

#include <doctest/doctest.h>

#include <string>

using namespace isoscope;
using isoscope::test::run_window;

namespace {

/// Goes through a lesson that is on by commands; wrong at the first question, right at all others.
std::string walk(const Lesson& lesson) {
  std::string script;
  bool wrong = true;
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
      script += "expect lesson.phase == trying\n";
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
                     "lesson:" + lesson.name + " --size 800x500") == 0);
  }
}

} // namespace

TEST_CASE("every odd lesson can be gone through, and what it says holds") {
  walk_every_second(0);
}

TEST_CASE("every even lesson can be gone through, and what it says holds" * doctest::test_suite("even")) {
  walk_every_second(1);
}
