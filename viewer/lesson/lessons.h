// Lessons in the window: the one under way, its pane, the list of all.
#pragma once

#include "lesson/handout.h"
#include "lesson/lesson_runner.h"

#include <cstdint>
#include <span>

namespace isoscope {

struct Ui;

class Lessons {
 public:
  Lessons(WindowState& shared, const CommandTable& commands, const NamedValues& values, Exports& exports)
      : window(shared), runner(shared, commands, values), handout(runner, exports) {}

  WindowState& window;
  LessonRunner runner;
  Handout handout;

  /// Once a frame, after the window's update; true when something changed.
  bool update();
  /// Whether nothing goes on by itself.
  bool idle() const { return runner.idle() && !handout.busy(); }

  void add_commands(CommandTable& table);
  void add_values(NamedValues& values);
};

namespace panels {

/// Text, question or task of the stop, how far the lesson is, and the way on. Fills the pane it is in.
void lesson(Ui& ui, const LessonRunner& runner);
/// The same for the presenter: heading and text as a caption at the bottom of the window, as high as it
/// needs.
void lesson_caption(Ui& ui, const LessonRunner& runner);
float lesson_caption_height(const Ui& ui, const LessonRunner& runner, float width);
/// All lessons as rows that begin them. `textures`: the pictures of bundled_lessons(), 0 where there is none.
void lesson_list(Ui& ui, std::span<const std::uint32_t> textures);

} // namespace panels

} // namespace isoscope
