// A lesson as its file tells it: a head, then stops with text, commands, a question or a thing to try.
#pragma once

#include "base/status.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// Asked before the scene goes on; a guess shows which answer is right and why.
struct LessonQuestion {
  struct Answer {
    std::string text;
    bool right = false;
  };
  std::string text;
  std::vector<Answer> answers;     ///< two to four, of which one is right
  std::vector<std::string> reveal; ///< commands after the guess
  std::string why;                 ///< what is said then
  /// Comparisons of named values that hold then: what makes the right answer right.
  std::vector<std::string> checks;
  std::size_t right() const;
};

/// Something to do, which may be skipped.
struct LessonTask {
  std::string text;
  std::string until; ///< the comparison of named values that tells when it is done
  std::string hint;  ///< said after a while
};

struct LessonStop {
  std::string heading;
  std::string text; ///< paragraphs, divided by an empty line
  std::vector<std::string> commands;
  std::vector<std::string> checks; ///< comparisons that hold after them
  std::optional<LessonQuestion> question;
  std::optional<LessonTask> task;
};

struct Lesson {
  int number = 0;
  std::string name; ///< what it is called by: "link-condition"
  std::string title;
  std::string figure; ///< of the paper: "Figure 6"
  int minutes = 0;
  std::string model;                 ///< gallery:NAME
  std::vector<std::string> settings; ///< "NAME VALUE" of the run's parameters
  std::vector<LessonStop> stops;
};

/// Reads `NN-name.md`: the grammar is told in assets/lessons/README.md. Fails with bad_input, naming the
/// line.
Result<Lesson> parse_lesson(std::string_view file, std::string_view text);

/// The lessons that the program carries, by number.
const Result<std::vector<Lesson>>& bundled_lessons();
/// By name or number; null where there is none.
const Lesson* find_lesson(std::string_view name);

/// A picture of it, JPEG, which the program carries; empty where there is none.
std::span<const std::byte> picture_of(const Lesson& lesson);

/// What an input begins with that is a lesson: "lesson:kernel".
inline constexpr std::string_view lesson_prefix = "lesson:";

} // namespace isoscope
