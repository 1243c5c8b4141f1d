// Stop after stop: guess, picture, text.
#include "lesson/handout.h"

#include "base/markup.h"
#include "base/pending_file.h"

#include <algorithm>
#include <cstdio>

namespace isoscope {
namespace {

/// The paragraphs of a text, each through `shown`, with something between them.
template <class Shown>
std::string paragraphs(std::string_view text, std::string_view between, const Shown& shown) {
  std::string out;
  for (std::size_t end = 0; end < text.size(); text.remove_prefix(std::min(end + 1, text.size()))) {
    end = std::min(text.find('\n'), text.size());
    if (!out.empty()) out += between;
    out += shown(text.substr(0, end));
  }
  return out;
}

std::string markdown(std::string_view text) {
  return paragraphs(text, "\n\n", [](std::string_view p) { return p; });
}

std::string html(std::string_view text) {
  return "<p>" + paragraphs(text, "</p><p>", escaped_markup) + "</p>";
}

Status write_file(const std::filesystem::path& path, const std::string& text) {
  PendingFile file;
  if (Status opened = file.open(path); !opened) return opened;
  file.append(text);
  return file.commit();
}

std::string subtitle(const Lesson& lesson) {
  return (lesson.figure.empty() ? "" : lesson.figure + ", ") + lesson.model;
}

} // namespace

std::string handout_markdown(const Lesson& lesson, const std::vector<HandoutPage>& pages) {
  std::string out = "# " + lesson.title + "\n\n" + subtitle(lesson) + "\n";
  for (const HandoutPage& page : pages) {
    out += "\n## " + page.heading + "\n\n![" + page.heading + "](" + page.picture + ")\n";
    if (!page.text.empty()) out += "\n" + markdown(page.text) + "\n";
    if (!page.question.empty()) out += "\n**" + page.question + "**\n\n";
    for (std::size_t i = 0; i < page.answers.size(); ++i)
      out += std::to_string(i + 1) + ". " + page.answers[i] + "\n";
    if (!page.why.empty())
      out += "\nAnswer " + std::to_string(page.right + 1) + ". " + markdown(page.why) + "\n";
    if (!page.task.empty()) out += "\n*Try:* " + page.task + "\n";
  }
  return out;
}

std::string handout_html(const Lesson& lesson, const std::vector<HandoutPage>& pages) {
  std::string out =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
      escaped_markup(lesson.title) +
      "</title>\n<style>body{font:17px/1.5 sans-serif;max-width:60em;margin:2em auto;padding:0 1em}"
      "section{break-inside:avoid;margin:2.5em 0}img{max-width:100%;border:1px solid #ccc}"
      "details{margin:.6em 0}</style></head>\n<body><h1>" +
      escaped_markup(lesson.title) + "</h1><p>" + escaped_markup(subtitle(lesson)) + "</p>\n";
  for (const HandoutPage& page : pages) {
    out += "<section><h2>" + escaped_markup(page.heading) + "</h2><img src=\"" +
           escaped_markup(page.picture) + "\" alt=\"" + escaped_markup(page.heading) + "\">\n";
    if (!page.text.empty()) out += html(page.text) + "\n";
    if (!page.question.empty()) {
      out += "<p><b>" + escaped_markup(page.question) + "</b></p><ol>";
      for (const std::string& answer : page.answers) out += "<li>" + escaped_markup(answer) + "</li>";
      out += "</ol><details><summary>Answer " + std::to_string(page.right + 1) + "</summary>" +
             html(page.why) + "</details>\n";
    }
    if (!page.task.empty()) out += "<p><i>Try:</i> " + escaped_markup(page.task) + "</p>\n";
    out += "</section>\n";
  }
  return out + "</body></html>\n";
}

Status Handout::begin(const Lesson& lesson, const std::filesystem::path& folder, PictureFormat format) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    return Error{ErrorCode::io, "The folder " + folder.string() + " cannot be made: " + error.message() + ".",
                 "Choose another folder."};
  if (Status begun = runner_.begin(lesson); !begun) return begun;
  lesson_ = &lesson;
  folder_ = folder;
  format_ = format;
  pages_.clear();
  busy_ = true;
  pictured_ = false;
  return {};
}

void Handout::fail(const Error& error) {
  busy_ = false;
  runner_.end();
  exports_.error = error;
  exports_.window.report(error);
}

void Handout::take_page() {
  const LessonStop& stop = *runner_.shown();
  char number[8];
  std::snprintf(number, sizeof number, "%02zu", runner_.stop() + 1);
  HandoutPage page;
  page.heading = stop.heading;
  page.text = runner_.text();
  page.picture = std::string(number) + ".png";
  if (stop.question) {
    page.question = runner_.filled(stop.question->text);
    for (const LessonQuestion::Answer& answer : stop.question->answers) page.answers.push_back(answer.text);
    page.right = stop.question->right();
    page.why = runner_.why();
  }
  if (stop.task) page.task = stop.task->text;
  exports_.wanted.push_back(PictureRequest{(folder_ / page.picture).string(), format_, std::nullopt});
  pages_.push_back(std::move(page));
}

Status Handout::write() const {
  if (Status written = write_file(folder_ / "lesson.md", handout_markdown(*lesson_, pages_)); !written)
    return written;
  return write_file(folder_ / "lesson.html", handout_html(*lesson_, pages_));
}

void Handout::update() {
  if (!busy_ || exports_.pending() || !runner_.idle()) return;
  // Somebody left the lesson, or began another one.
  if (runner_.lesson() != lesson_) {
    busy_ = false;
    return;
  }
  if (runner_.phase() == LessonPhase::failed) return fail({ErrorCode::internal, runner_.error(), ""});
  if (pictured_ && exports_.error) return fail(Error(*exports_.error));
  const LessonStop* stop = runner_.shown();
  if (stop == nullptr) {
    busy_ = false;
    if (Status written = write(); !written) return fail(written.error());
    runner_.end();
    exports_.window.tell("The lesson is written to " + (folder_ / "lesson.html").string() + ".");
    return;
  }
  if (runner_.phase() == LessonPhase::asking) {
    if (Status answered = runner_.answer(stop->question->right()); !answered) fail(answered.error());
    return;
  }
  if (pictured_) {
    pictured_ = false;
    runner_.go(runner_.stop() + 1);
    return;
  }
  exports_.error.reset();
  take_page();
  pictured_ = true;
}

} // namespace isoscope
