// A lesson as a folder: a picture a stop with its text, as Markdown and HTML, for slides and handouts.
#pragma once

#include "export/exports.h"
#include "lesson/lesson_runner.h"

#include <filesystem>
#include <string>
#include <vector>

namespace isoscope {

/// A stop as it is printed, with the values that were shown.
struct HandoutPage {
  std::string heading, text, picture; ///< the picture's file name
  std::string question, task;
  std::vector<std::string> answers;
  std::size_t right = 0; ///< of the answers
  std::string why;
};

std::string handout_markdown(const Lesson& lesson, const std::vector<HandoutPage>& pages);
std::string handout_html(const Lesson& lesson, const std::vector<HandoutPage>& pages);

/// Goes through a lesson by itself, gives the right answers, and keeps what is seen.
class Handout {
 public:
  Handout(LessonRunner& runner, Exports& exports) : runner_(runner), exports_(exports) {}

  /// Fails with io where the folder cannot be made.
  Status begin(const Lesson& lesson, const std::filesystem::path& folder, PictureFormat format);
  bool busy() const { return busy_; }
  /// Once a frame, after the runner's update. What fails is reported in the window.
  void update();

 private:
  void fail(const Error& error);
  void take_page();
  Status write() const;

  LessonRunner& runner_;
  Exports& exports_;
  const Lesson* lesson_ = nullptr;
  std::filesystem::path folder_;
  PictureFormat format_;
  std::vector<HandoutPage> pages_;
  bool busy_ = false, pictured_ = false; ///< pictured: the stop's picture is asked for
};

} // namespace isoscope
