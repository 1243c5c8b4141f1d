// Reading lessons: Markdown with fenced blocks.
#include "lesson/lesson.h"

#include "base/numbers.h"
#include "embedded/lesson_pictures.h"
#include "embedded/lessons.h"

#include <algorithm>

namespace isoscope {
namespace {

constexpr std::size_t fewest_answers = 2, most_answers = 4;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Adds a line to a paragraph.
void append(std::string& text, std::string_view line) {
  if (!text.empty() && text.back() != '\n') text += ' ';
  text += line;
}

class LessonReader {
 public:
  LessonReader(std::string_view file, std::string_view text) : file_(file), text_(text) {}

  Result<Lesson> read() {
    for (; !text_.empty() && problem_.empty(); ++number_) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      take(trimmed(text_.substr(0, end)));
      text_.remove_prefix(std::min(end + 1, text_.size()));
    }
    if (problem_.empty()) finish();
    if (problem_.empty()) return std::move(lesson_);
    return Error{ErrorCode::bad_input,
                 "Lesson " + std::string(file_) + ", line " + std::to_string(number_) + ": " + problem_, ""};
  }

 private:
  enum class Block { none, head, commands, question, task };

  void take(std::string_view line) {
    if (line.starts_with("```")) return fence(line.substr(3));
    switch (block_) {
    case Block::none:
      return prose(line);
    case Block::head:
      return head(line);
    case Block::commands:
      return command(line);
    case Block::question:
      return question(line);
    case Block::task:
      return task(line);
    }
  }

  void fence(std::string_view kind) {
    if (block_ != Block::none) {
      block_ = Block::none;
      return;
    }
    if (kind == "lesson") {
      block_ = Block::head;
      return;
    }
    if (lesson_.stops.empty()) return fail("A block stands before the first heading.");
    LessonStop& stop = lesson_.stops.back();
    if (kind == "do")
      block_ = Block::commands;
    else if (kind == "ask" && !stop.question && !stop.task) {
      block_ = Block::question;
      stop.question.emplace();
    } else if (kind == "try" && !stop.question && !stop.task) {
      block_ = Block::task;
      stop.task.emplace();
    } else {
      fail("\"" + std::string(kind) + "\" is no block, or the stop has its question or task already.");
    }
  }

  void prose(std::string_view line) {
    if (line.starts_with("## ")) {
      lesson_.stops.emplace_back().heading = trimmed(line.substr(3));
    } else if (line.starts_with("# ")) {
      lesson_.title = trimmed(line.substr(2));
    } else if (!lesson_.stops.empty()) {
      std::string& text = lesson_.stops.back().text;
      if (!line.empty())
        append(text, line);
      else if (!text.empty() && text.back() != '\n')
        text += '\n';
    }
  }

  /// Divides "key: value".
  bool divide(std::string_view line, std::string_view& key, std::string_view& value) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string_view::npos) return false;
    key = line.substr(0, colon);
    value = trimmed(line.substr(colon + 2));
    return true;
  }

  void head(std::string_view line) {
    std::string_view key, value;
    if (line.empty()) return;
    if (!divide(line, key, value)) return fail("A line of the head is \"key: value\".");
    if (key == "figure")
      lesson_.figure = value;
    else if (key == "model")
      lesson_.model = value;
    else if (key == "set")
      lesson_.settings.emplace_back(value);
    else if (const auto minutes = read_number(value); key == "minutes" && minutes)
      lesson_.minutes = static_cast<int>(*minutes);
    else
      fail("\"" + std::string(line) + "\" is not understood.");
  }

  void command(std::string_view line) {
    std::string_view key, value;
    if (line.empty()) return;
    LessonStop& stop = lesson_.stops.back();
    if (divide(line, key, value) && key == "check")
      stop.checks.emplace_back(value);
    else
      stop.commands.emplace_back(line);
  }

  void question(std::string_view line) {
    LessonQuestion& q = *lesson_.stops.back().question;
    std::string_view key, value;
    if (line.empty()) return;
    if (line.starts_with("( ) ") || line.starts_with("(x) "))
      q.answers.push_back({std::string(trimmed(line.substr(4))), line[1] == 'x'});
    else if (q.answers.empty())
      append(q.text, line);
    else if (!divide(line, key, value))
      q.why.empty() ? fail("Answers begin with ( ) or (x).") : append(q.why, line);
    else if (key == "do")
      q.reveal.emplace_back(value);
    else if (key == "check")
      q.checks.emplace_back(value);
    else if (key == "why")
      q.why = value;
    else
      q.why.empty() ? fail("\"" + std::string(key) + "\" is not understood.") : append(q.why, line);
  }

  void task(std::string_view line) {
    LessonTask& t = *lesson_.stops.back().task;
    std::string_view key, value;
    if (line.empty()) return;
    if (divide(line, key, value) && key == "until")
      t.until = value;
    else if (divide(line, key, value) && key == "hint")
      t.hint = value;
    else
      append(t.hint.empty() ? t.text : t.hint, line);
  }

  void finish() {
    const std::size_t dash = file_.find('-'), end = file_.rfind('.');
    const auto number = read_number(file_.substr(0, std::min(dash, file_.size())));
    if (!number || end == std::string_view::npos || end <= dash)
      return fail("The file is not called NN-name.md.");
    lesson_.number = static_cast<int>(*number);
    lesson_.name = file_.substr(dash + 1, end - dash - 1);
    if (block_ != Block::none) return fail("The last block does not end.");
    if (lesson_.title.empty() || lesson_.model.empty() || lesson_.stops.empty())
      return fail("Title, model or stops are missing.");
    for (LessonStop& stop : lesson_.stops) {
      while (!stop.text.empty() && stop.text.back() == '\n') stop.text.pop_back();
      if (stop.question) judge(*stop.question, stop.heading);
      if (stop.task && (stop.task->text.empty() || stop.task->until.empty()))
        fail("What is to be done at \"" + stop.heading + "\", or until when, is missing.");
    }
  }

  void judge(const LessonQuestion& q, const std::string& heading) {
    const auto right =
        std::count_if(q.answers.begin(), q.answers.end(), [](const auto& a) { return a.right; });
    if (q.answers.size() < fewest_answers || q.answers.size() > most_answers || right != 1)
      fail("\"" + heading + "\" does not have two to four answers of which one is right.");
    else if (q.why.empty() || q.checks.empty())
      fail("\"" + heading + "\" does not say why, or by which number.");
  }

  void fail(std::string what) { problem_ = std::move(what); }

  std::string_view file_, text_;
  std::size_t number_ = 1;
  Block block_ = Block::none;
  std::string problem_;
  Lesson lesson_;
};

} // namespace

std::size_t LessonQuestion::right() const {
  const auto at = std::find_if(answers.begin(), answers.end(), [](const Answer& a) { return a.right; });
  return static_cast<std::size_t>(at - answers.begin());
}

Result<Lesson> parse_lesson(std::string_view file, std::string_view text) {
  return LessonReader(file, text).read();
}

const Result<std::vector<Lesson>>& bundled_lessons() {
  static const Result<std::vector<Lesson>> lessons = []() -> Result<std::vector<Lesson>> {
    std::vector<Lesson> all;
    for (const EmbeddedFile& file : embedded::lessons()) {
      auto lesson = parse_lesson(file.name, file.text());
      if (!lesson) return lesson.error();
      all.push_back(std::move(*lesson));
    }
    std::sort(all.begin(), all.end(), [](const Lesson& a, const Lesson& b) { return a.number < b.number; });
    return all;
  }();
  return lessons;
}

const Lesson* find_lesson(std::string_view name) {
  const auto& all = bundled_lessons();
  if (!all) return nullptr;
  for (const Lesson& lesson : *all)
    if (lesson.name == name || std::to_string(lesson.number) == name) return &lesson;
  return nullptr;
}

std::span<const std::byte> picture_of(const Lesson& lesson) {
  const EmbeddedFile* file = find_embedded(embedded::lesson_pictures(), lesson.name + ".jpg");
  return file != nullptr ? file->bytes : std::span<const std::byte>();
}

} // namespace isoscope
