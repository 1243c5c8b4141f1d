// Commands on lessons, and what scripts read of them.
#include "lesson/lessons.h"

#include "ui/icons.h"

#include <GLFW/glfw3.h>

namespace isoscope {
namespace {

Error no_lesson(const std::string& name) {
  return {ErrorCode::usage, "There is no lesson \"" + name + "\".", "isoscope --list-lessons names them."};
}

Status begin_lesson(Lessons& m, const Arguments& a) {
  if (a.empty()) {
    m.window.toggle(Overlay::lessons);
    return {};
  }
  if (const auto& all = bundled_lessons(); !all) return all.error();
  const Lesson* lesson = find_lesson(a[0]);
  if (lesson == nullptr) return no_lesson(a[0]);
  std::size_t stop = 0;
  if (a.size() > 1) {
    const auto given = whole_argument(a, 1, 1, lesson->stops.size());
    if (!given) return wrong_arguments("It has " + std::to_string(lesson->stops.size()) + " stops.");
    stop = *given - 1;
  }
  return m.runner.begin(*lesson, stop);
}

Status answer(Lessons& m, const Arguments& a) {
  if (a.size() == 1 && a[0] == "right" && m.runner.shown() != nullptr && m.runner.shown()->question)
    return m.runner.answer(m.runner.shown()->question->right());
  const auto which = whole_argument(a, 0, 1);
  if (!which) return wrong_arguments("Which answer?");
  return m.runner.answer(*which - 1);
}

Status write_handout(Lessons& m, const Arguments& a) {
  if (a.size() < 2 || a.size() > 3) return wrong_arguments("A lesson and a folder are needed.");
  const Lesson* lesson = find_lesson(a[0]);
  if (lesson == nullptr) return no_lesson(a[0]);
  PictureFormat format{1280, 800, false};
  if (a.size() == 3 && !(read_size(a[2], format) && is_possible(format)))
    return wrong_arguments("\"" + a[2] + "\" is no size.");
  return m.handout.begin(*lesson, a[1], format);
}

} // namespace

bool Lessons::update() {
  const LessonPhase before = runner.phase();
  const bool working = !idle();
  runner.update();
  handout.update();
  return working || before != runner.phase();
}

void Lessons::add_commands(CommandTable& table) {
  const auto on_lesson = [this] { return runner.on(); };
  add_group(table, {.menu = "Talk"},
            {{.name = "lesson",
              .title = "Lessons…",
              .usage = "[NAME | NUMBER] [STOP]",
              .help = "Begins a lesson, at one of its stops; without a name it lists them.",
              .icon = icon::graduation,
              .keys = {{'L', true}},
              .run = on(*this, begin_lesson)},
             {.name = "lesson-next",
              .title = "Go on in the lesson",
              .help = "To the next stop; what is asked or to be done is skipped.",
              .icon = icon::forward,
              .keys = {{GLFW_KEY_PAGE_DOWN}, {GLFW_KEY_ENTER}},
              .run = does([this] { runner.go(runner.stop() + 1); }),
              .enabled = [this] { return runner.shown() != nullptr; }},
             {.name = "lesson-back",
              .title = "Go back in the lesson",
              .help = "To the stop before.",
              .icon = icon::back,
              .keys = {{GLFW_KEY_PAGE_UP}, {GLFW_KEY_BACKSPACE}},
              .run = does([this] { runner.go(runner.stop() - 1); }),
              .enabled = [this] { return runner.on() && runner.stop() > 0; }},
             {.name = "lesson-hint",
              .title = "Show the hint",
              .help = "Of the thing that is to be done.",
              .run = does([this] { runner.show_hint(); }),
              .enabled = [this] { return runner.phase() == LessonPhase::trying; }},
             {.name = "lesson-end",
              .title = "Leave the lesson",
              .help = "Gives back the layout that was there; the run stays.",
              .icon = icon::close,
              .keys = {{'L', true, true}},
              .run = does([this] { runner.end(); }),
              .enabled = on_lesson}});
  table.add(
      {{.name = "lesson-pages",
        .title = "Write a lesson as pages…",
        .usage = "NAME FOLDER [WIDTHxHEIGHT]",
        .help = "Goes through a lesson and writes a picture a stop with its text, as Markdown and HTML.",
        .run = on(*this, write_handout)},
       {.name = "lesson-answer",
        .title = "Answer…",
        .usage = "N | right",
        .help = "Gives an answer to what the lesson asks.",
        .run = on(*this, answer),
        .enabled = [this] { return runner.phase() == LessonPhase::asking; }}});
  // A lesson that asks takes the numbers from the kinds that a click selects.
  for (int i = 1; i <= 4; ++i) {
    const std::string number = std::to_string(i);
    table.add({{.name = "lesson-answer-" + number,
                .title = "Answer " + number,
                .help = "Takes this answer, where a lesson asks.",
                .keys = {{'0' + i}},
                .run = [this, number](const Arguments&) { return answer(*this, {number}); },
                .enabled = [this] { return runner.phase() == LessonPhase::asking; }}});
  }
}

void Lessons::add_values(NamedValues& values) {
  const auto of = values.readings("lesson.", [this] { return runner.lesson(); });
  of("name", "the lesson that is on", &Lesson::name);
  of("title", "its title", &Lesson::title);
  of("stops", "how many stops it has", [](const Lesson& l) { return l.stops.size(); });
  of("stop", "the stop shown, from 1", [this](const Lesson&) { return runner.stop() + 1; });
  values.add("lesson.phase", "off, working, asking, revealing, trying, reading, finished or failed",
             [this] { return runner.phase(); });
  values.add("lesson.error", "what went wrong in it",
             [this] { return runner.error().empty() ? std::string("none") : runner.error(); });
  values.add("lesson.asked", "questions answered", [this] { return runner.asked(); });
  values.add("lesson.right", "of them right at the first guess", [this] { return runner.right(); });
  values.add("lesson.hint", "whether the hint of what is to be done is shown",
             [this] { return runner.hinted(); });
  values.add("lesson.done", "whether what was to be done is done", [this] { return runner.task_done(); });
}

} // namespace isoscope
