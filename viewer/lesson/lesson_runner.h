// A lesson under way: what it has shown, what it waits for, what was answered.
#pragma once

#include "command/commands.h"
#include "command/named_values.h"
#include "lesson/lesson.h"
#include "model/window_state.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// What a lesson does at the moment.
enum class LessonPhase : std::uint8_t {
  off,
  working,   ///< the commands of the stop are carried out
  asking,    ///< for a guess
  revealing, ///< the commands after the guess
  trying,    ///< until something is done
  reading,   ///< nothing is left but to go on
  finished,  ///< after the last stop
  failed     ///< a command or a check did
};
std::string_view name(LessonPhase phase);

/// Replaces {name} by a named value; {name:5} gives five digits instead of three.
std::string with_values(std::string_view text, const NamedValues& values);
/// The same as long as they are not known: an ellipsis for each.
std::string with_gaps(std::string_view text);

class LessonRunner {
 public:
  /// All must outlive it. Commands go to the table.
  LessonRunner(WindowState& window, const CommandTable& commands, const NamedValues& values)
      : window_(window), commands_(commands), values_(values) {}

  /// Opens its model and goes to a stop, from 0.
  Status begin(const Lesson& lesson, std::size_t stop = 0);
  /// Gives back layout, camera, layers, clip, section and filter as they were; the run stays.
  void end();
  /// To a stop; past the last one the lesson is finished.
  void go(std::size_t stop);
  /// A guess, from 0. Fails with usage where none is asked for.
  Status answer(std::size_t which);
  /// Once a frame, after the window's update.
  void update();

  bool on() const { return lesson_ != nullptr; }
  /// Whether it waits for a person.
  bool idle() const { return phase_ != LessonPhase::working && phase_ != LessonPhase::revealing; }
  const Lesson* lesson() const { return lesson_; }
  std::size_t stop() const { return stop_; }
  /// Null when it is finished or off.
  const LessonStop* shown() const;
  LessonPhase phase() const { return phase_; }
  std::optional<std::size_t> guess() const { return guess_; }
  bool task_done() const { return task_done_; }
  /// Whether the hint of the task is due.
  bool hinted() const;
  void show_hint() { hint_at_ = window_.clock; }
  /// Of the questions that were answered.
  std::size_t asked() const;
  std::size_t right() const;
  const std::string& error() const { return error_; }
  /// The stop's text and why, with the values of now.
  std::string text() const;
  std::string why() const;
  /// A text of the lesson with the values of now, or with gaps while the scene is still being made; without
  /// the marks that pages set code in.
  std::string filled(std::string_view text) const;

 private:
  void enter(LessonPhase phase);
  void follow(const std::vector<std::string>& commands, LessonPhase phase);
  void fail(std::string what);
  bool passes(const std::vector<std::string>& checks);
  /// Runs its model with its parameters.
  Status open(const Lesson& lesson);
  void keep_look();
  void give_look_back();

  WindowState& window_;
  const CommandTable& commands_;
  const NamedValues& values_;
  const Lesson* lesson_ = nullptr;
  std::size_t stop_ = 0;
  LessonPhase phase_ = LessonPhase::off;
  std::vector<std::string> pending_; ///< commands, the next one last
  std::size_t tried_at_ = 0;         ///< events of the journal when the next one failed
  std::uint64_t generation_ = 0;     ///< of the run that was shown before
  std::optional<std::uint64_t> own_; ///< of the lesson's run, once it is there
  std::optional<std::size_t> guess_;
  std::vector<std::optional<bool>> results_; ///< by stop: whether the guess was right
  bool task_done_ = false;
  double hint_at_ = 0;
  std::string error_;
  struct Before {
    ViewMemento look;
    bool camera_set = false, section_set = false; ///< by somebody, not by the program
  };
  std::optional<Before> before_; ///< what end() gives back
};

} // namespace isoscope
