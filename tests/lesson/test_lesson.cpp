// Reading lessons: the grammar, what is refused, and that those of the program keep their rules.
#include "lesson/lesson.h"
#include "lesson/lesson_runner.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>
#include <string>

using namespace isoscope;

namespace {

const std::string head = "# A title\n\n```lesson\nfigure: Figure 9\nminutes: 4\nmodel: gallery:sphere\nset: "
                         "alpha 0.3\n```\n\n";

std::string refusal(const std::string& text, const std::string& file = "03-name.md") {
  const auto lesson = parse_lesson(file, text);
  return lesson ? "" : lesson.error().message;
}

std::size_t words_of(const std::string& text) {
  std::istringstream in(text);
  std::size_t count = 0;
  for (std::string word; in >> word;) ++count;
  return count;
}

} // namespace

TEST_CASE("a lesson's head, texts and blocks are read") {
  const auto lesson = parse_lesson("12-two-words.md", head + R"(## First

Some text
that goes on.

Another paragraph.

```do
seek 3
check: bad_samples == 2
```

```ask
Which
one?
( ) this
(x) that one
do: step
check: step == 4
why: Because it is: the number says so,
over two lines.
```

## Second

```try
Press a key.
until: step > 4
hint: Any
key.
```
)");
  REQUIRE(lesson.ok());
  CHECK(lesson->number == 12);
  CHECK(lesson->name == "two-words");
  CHECK(lesson->title == "A title");
  CHECK(lesson->figure == "Figure 9");
  CHECK(lesson->minutes == 4);
  CHECK(lesson->model == "gallery:sphere");
  CHECK(lesson->settings == std::vector<std::string>{"alpha 0.3"});
  REQUIRE(lesson->stops.size() == 2);
  const LessonStop& first = lesson->stops[0];
  CHECK(first.heading == "First");
  CHECK(first.text == "Some text that goes on.\nAnother paragraph.");
  CHECK(first.commands == std::vector<std::string>{"seek 3"});
  CHECK(first.checks == std::vector<std::string>{"bad_samples == 2"});
  REQUIRE(first.question);
  CHECK(first.question->text == "Which one?");
  CHECK(first.question->answers.size() == 2);
  CHECK(first.question->right() == 1);
  CHECK(first.question->reveal == std::vector<std::string>{"step"});
  CHECK(first.question->checks == std::vector<std::string>{"step == 4"});
  CHECK(first.question->why == "Because it is: the number says so, over two lines.");
  const LessonStop& second = lesson->stops[1];
  REQUIRE(second.task);
  CHECK(second.task->text == "Press a key.");
  CHECK(second.task->until == "step > 4");
  CHECK(second.task->hint == "Any key.");
}

TEST_CASE("what is wrong with a lesson is said with its line") {
  CHECK(refusal(head + "## A\n\n```dance\n").find("line 13") != std::string::npos);
  CHECK(refusal(head + "## A\n\n```ask\nWhy?\n( ) a\n( ) b\ncheck: step == 1\nwhy: so\n```\n")
            .find("one is right") != std::string::npos);
  CHECK(refusal(head + "## A\n\n```ask\nWhy?\n(x) a\n( ) b\nwhy: so\n```\n").find("by which number") !=
        std::string::npos);
  CHECK(refusal(head + "## A\n\n```try\nDo it.\n```\n").find("until when") != std::string::npos);
  CHECK(refusal(head + "## A\n\n```do\nseek 3\n").find("does not end") != std::string::npos);
  CHECK(refusal(head).find("missing") != std::string::npos);
  CHECK(refusal(head + "```do\n").find("first heading") != std::string::npos);
  CHECK(refusal(head + "## A\n", "name.md").find("NN-name.md") != std::string::npos);
  CHECK(refusal("# T\n```lesson\nmodel gallery:sphere\n```\n## A\n").find("key: value") != std::string::npos);
}

TEST_CASE("texts say named values with as many digits as asked for") {
  NamedValues values;
  double number = 2.0 / 3;
  values.add("ratio", "a number", [&] { return number; });
  values.add("count", "a whole number", [] { return 123456; });
  values.add("word", "a word", [] { return std::string("bad"); });
  CHECK(with_values("{ratio} of {count} are {word}", values) == "0.667 of 123,456 are bad");
  CHECK(with_values("{ratio:6}", values) == "0.666667");
  CHECK(with_values("{nothing} and {open", values) == "nothing? and {open");
  CHECK(with_gaps("{ratio} of {count} are bad") == "\u2026 of \u2026 are bad");
}

TEST_CASE("the lessons that the program carries keep their rules") {
  const auto& lessons = bundled_lessons();
  REQUIRE_MESSAGE(lessons.ok(), lessons.error().message);
  CHECK(lessons->size() == 19);
  int number = 0;
  for (const Lesson& lesson : *lessons) {
    CAPTURE(lesson.name);
    CHECK(lesson.number > number);
    number = lesson.number;
    CHECK(lesson.minutes > 0);
    CHECK(lesson.stops.size() >= 5);
    CHECK(lesson.stops.size() <= 8);
    CHECK(!picture_of(lesson).empty());
    CHECK(find_lesson(lesson.name) == &lesson);
    CHECK(find_lesson(std::to_string(lesson.number)) == &lesson);
    CHECK(std::any_of(lesson.stops.begin(), lesson.stops.end(),
                      [](const LessonStop& s) { return s.question || s.task; }));
    for (const LessonStop& stop : lesson.stops) {
      CAPTURE(stop.heading);
      CHECK(words_of(stop.text) <= 60);
      // A step is found by what happens there; only the beginning has a number.
      for (const std::string& command : stop.commands)
        CHECK_MESSAGE((!command.starts_with("seek") || command == "seek 0"), command);
      if (stop.question)
        for (const std::string& command : stop.question->reveal) CHECK(!command.starts_with("seek"));
      CHECK(!(stop.text.empty() && !stop.question && !stop.task));
    }
  }
  CHECK(find_lesson("nothing of the kind") == nullptr);
}
