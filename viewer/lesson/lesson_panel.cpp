// The pane of a lesson, its caption before an audience, and the list of lessons.
#include "lesson/lessons.h"

#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>

namespace isoscope::panels {
namespace {

constexpr float disc_step = 16;

float stops_width(const Ui& ui, const LessonRunner& runner) {
  return static_cast<float>(runner.lesson()->stops.size()) * ui.px(disc_step);
}

/// A disc a stop: passed, shown, to come.
void stops_line(const Ui& ui, const LessonRunner& runner) {
  const std::size_t count = runner.lesson()->stops.size();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float step = ui.px(disc_step), y = at.y + ui.px(7);
  for (std::size_t i = 0; i < count; ++i) {
    const ImVec2 middle{at.x + ui.px(5) + static_cast<float>(i) * step, y};
    if (i < runner.stop())
      list.AddCircleFilled(middle, ui.px(4), to_u32(ui.colors.accent, 0.55f));
    else if (i == runner.stop())
      list.AddCircleFilled(middle, ui.px(5), to_u32(ui.colors.accent));
    else
      list.AddCircle(middle, ui.px(4), to_u32(ui.colors.quiet), 0, ui.px(1.2f));
  }
  ImGui::Dummy({stops_width(ui, runner), ui.px(14)});
}

void paragraphs(const Ui& ui, std::string_view text, ImFont* font, Rgb color) {
  const widgets::Font used(font);
  ImGui::PushStyleColor(ImGuiCol_Text, to_vec(color));
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    widgets::wrapped_text(text.substr(0, end));
    ImGui::Dummy({0, ui.px(5)});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  ImGui::PopStyleColor();
}

void paragraphs(const Ui& ui, std::string_view text, ImFont* font) {
  paragraphs(ui, text, font, ui.colors.text);
}

/// An answer over the width that is left; true when it is taken.
bool answer_row(const Ui& ui, std::size_t number, const LessonQuestion::Answer& answer, bool open,
                bool chosen) {
  const widgets::Font font(ui.fonts.reading);
  const float pad = ui.px(10), mark = ui.px(30);
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string lines = widgets::broken_lines(ui.fonts.reading, answer.text, width - mark - 2 * pad);
  const float high = widgets::height_of(ui.fonts.reading, lines) + 2 * ui.px(8);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(static_cast<int>(number));
  const bool pressed = ImGui::InvisibleButton("answer", {width, high}) && open;
  ImGui::PopID();
  const bool hovered = open && ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + width, at.y + high};
  const Rgb edge = open           ? (hovered ? ui.colors.accent : ui.colors.line)
                   : answer.right ? ui.colors.good
                   : chosen       ? ui.colors.bad
                                  : ui.colors.line;
  list.AddRectFilled(at, end, to_u32(hovered ? ui.colors.hover : ui.colors.raised), ui.px(6));
  list.AddRect(at, end, to_u32(edge), ui.px(6), 0, ui.px(!open && (answer.right || chosen) ? 2.0f : 1.0f));
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const float strength = open || answer.right || chosen ? 1.0f : 0.6f;
  if (open || !(answer.right || chosen))
    widgets::draw_text(list, ui.fonts.mono, {at.x + pad, at.y + ui.px(10)}, to_u32(ui.colors.quiet, strength),
                       std::to_string(number + 1));
  else
    widgets::glyph(ui, {at.x + pad + ui.px(5), at.y + ui.px(19)}, 5, edge,
                   answer.right ? MarkerShape::disc : MarkerShape::cross);
  widgets::draw_text(list, ui.fonts.reading, {at.x + mark, at.y + ui.px(8)}, to_u32(ui.colors.text, strength),
                     lines);
  return pressed;
}

void question(Ui& ui, const LessonRunner& runner, const LessonQuestion& q) {
  paragraphs(ui, runner.filled(q.text), ui.fonts.reading_bold);
  const bool open = !runner.guess() && runner.phase() == LessonPhase::asking;
  if (open) ImGui::GetStateStorage()->SetInt(ImGui::GetID("told"), 0);
  for (std::size_t i = 0; i < q.answers.size(); ++i) {
    if (answer_row(ui, i, q.answers[i], !runner.guess(), runner.guess() == i) && open)
      ui.commands.post("lesson-answer", {std::to_string(i + 1)});
    ImGui::Dummy({0, ui.px(1)});
  }
  if (!runner.guess() || runner.phase() != LessonPhase::reading) return;
  ImGui::Dummy({0, ui.px(4)});
  const bool right = q.answers[*runner.guess()].right;
  paragraphs(ui, right ? "Yes." : "No: it is answer " + std::to_string(q.right() + 1) + ".",
             ui.fonts.reading_bold, right ? ui.colors.good_text : ui.colors.bad_text);
  paragraphs(ui, runner.why(), ui.fonts.reading);
  // What is said of a guess comes into sight once.
  ImGuiStorage& store = *ImGui::GetStateStorage();
  const ImGuiID told = ImGui::GetID("told");
  const int guess = static_cast<int>(8 * runner.stop() + *runner.guess()) + 1;
  if (store.GetInt(told) == guess) return;
  store.SetInt(told, guess);
  ImGui::SetScrollHereY(1);
}

void task(Ui& ui, const LessonRunner& runner, const LessonTask& t) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool done = runner.task_done();
  ImGui::Indent(ui.px(26));
  paragraphs(ui, t.text, ui.fonts.reading_bold);
  ImGui::Unindent(ui.px(26));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 middle{at.x + ui.px(9), at.y + ui.px(11)};
  list.AddCircle(middle, ui.px(8), to_u32(done ? ui.colors.good : ui.colors.accent), 0, ui.px(2));
  if (done) list.AddCircleFilled(middle, ui.px(5), to_u32(ui.colors.good));
  if (done) {
    paragraphs(ui, "Done.", ui.fonts.reading_bold, ui.colors.good_text);
  } else if (!t.hint.empty() && runner.hinted()) {
    paragraphs(ui, t.hint, ui.fonts.reading, ui.colors.quiet);
  } else if (!t.hint.empty() && runner.phase() == LessonPhase::trying) {
    if (widgets::plain_button(ui, "Hint")) ui.commands.post("lesson-hint");
  }
}

void finished(Ui& ui, const LessonRunner& runner) {
  {
    const widgets::Font font(ui.fonts.title);
    widgets::wrapped_text("The end");
  }
  ImGui::Dummy({0, ui.px(6)});
  if (runner.asked() > 0)
    paragraphs(ui,
               std::to_string(runner.right()) + " of " + std::to_string(runner.asked()) +
                   " questions were right at the first guess.",
               ui.fonts.reading);
  paragraphs(ui, "The run stays: everything in the window works on it.", ui.fonts.reading);
  if (const Lesson* next = find_lesson(std::to_string(runner.lesson()->number + 1)))
    if (widgets::primary_button(ui, ("Lesson " + std::to_string(next->number) + ": " + next->title).c_str(),
                                true, ImGui::GetContentRegionAvail().x))
      ui.commands.post("lesson", {next->name});
  if (widgets::plain_button(ui, "All lessons", true, ImGui::GetContentRegionAvail().x))
    ui.commands.post("lesson");
}

/// Always in sight, as the way on is.
void way_out(Ui& ui) {
  ImGui::Dummy({0, ui.px(18)});
  if (widgets::plain_button(ui, "Leave", true, ImGui::GetContentRegionAvail().x))
    ui.commands.post("lesson-end");
  widgets::command_tip(ui, "lesson-end");
}

std::string progress_text(const WindowState& window) {
  if (!window.running()) return "The scene is being prepared…";
  std::string text = "The run goes on";
  if (!window.run.part.empty()) text += ": " + window.run.part;
  return text + "…";
}

void way_on(Ui& ui, const LessonRunner& runner) {
  const float width = ImGui::GetContentRegionAvail().x, gap = ui.px(8), back = ui.px(84);
  if (widgets::plain_button(ui, "Back", runner.stop() > 0, back)) ui.commands.post("lesson-back");
  widgets::command_tip(ui, "lesson-back");
  ImGui::SameLine(0, gap);
  const bool waits = runner.phase() == LessonPhase::asking || runner.phase() == LessonPhase::trying;
  const bool last = runner.stop() + 1 == runner.lesson()->stops.size();
  const char* label = waits ? "Skip" : last ? "Finish" : "Next";
  const bool pressed = waits ? widgets::plain_button(ui, label, true, width - back - gap)
                             : widgets::primary_button(ui, label, runner.idle(), width - back - gap);
  if (pressed) ui.commands.post("lesson-next");
  widgets::command_tip(ui, "lesson-next");
}

std::string place_text(const LessonRunner& runner) {
  const Lesson& lesson = *runner.lesson();
  return (lesson.figure.empty() ? "" : lesson.figure + "  ·  ") + std::to_string(runner.stop() + 1) + " of " +
         std::to_string(lesson.stops.size());
}

constexpr float caption_margin = 16, caption_top = 32;

/// What the audience reads: the text, the question with its answers, what was right and why, what to do.
std::string caption_text(const LessonRunner& runner) {
  const LessonStop* stop = runner.shown();
  if (stop == nullptr) return {};
  std::string text = runner.text();
  if (stop->question && runner.guess() && runner.phase() == LessonPhase::reading) {
    text = stop->question->answers[stop->question->right()].text + ": " + runner.why();
  } else if (stop->question) {
    text = runner.filled(stop->question->text);
    for (std::size_t i = 0; i < stop->question->answers.size(); ++i)
      text += "   " + std::to_string(i + 1) + "\u00a0" + stop->question->answers[i].text;
  } else if (stop->task) {
    text += (text.empty() ? "" : " ") + stop->task->text;
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

} // namespace

void lesson(Ui& ui, const LessonRunner& runner) {
  const Lesson& lesson = *runner.lesson();
  const float foot = ui.px(52);
  {
    const widgets::Font font(ui.fonts.small);
    const float close_x = ImGui::GetWindowContentRegionMax().x - ui.px(24);
    const std::string head = "Lesson " + std::to_string(lesson.number) + "  ·  " + lesson.title;
    widgets::quiet_text(ui, widgets::fitted(head, close_x - ImGui::GetCursorPosX() - ui.px(6)));
    ImGui::SameLine(close_x);
    if (widgets::icon_button(ui, "leave", icon::close)) ui.commands.post("lesson-end");
    widgets::command_tip(ui, "lesson-end");
  }
  const LessonStop* stop = runner.shown();
  ImGui::BeginChild("lesson", {0, -foot});
  if (stop == nullptr) {
    finished(ui, runner);
    ImGui::EndChild();
    way_out(ui);
    return;
  }
  {
    const widgets::Font font(ui.fonts.title);
    widgets::wrapped_text(stop->heading);
  }
  ImGui::Dummy({0, ui.px(4)});
  paragraphs(ui, runner.text(), ui.fonts.reading);
  if (stop->question) question(ui, runner, *stop->question);
  if (stop->task) task(ui, runner, *stop->task);
  if (runner.phase() == LessonPhase::failed) {
    paragraphs(ui, runner.error(), ui.fonts.small, ui.colors.bad_text);
  } else if (!runner.idle()) {
    widgets::quiet_text(ui, progress_text(ui.window), true);
  }
  ImGui::EndChild();
  {
    // The discs say what the words say: they go where both have no room.
    const std::string place = place_text(runner);
    const float wide = widgets::width_of(ui.fonts.small, place);
    if (stops_width(ui, runner) + ui.px(8) + wide <= ImGui::GetContentRegionAvail().x) {
      stops_line(ui, runner);
      ImGui::SameLine();
      ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - wide);
    }
    widgets::quiet_text(ui, place);
  }
  way_on(ui, runner);
}

float lesson_caption_height(const Ui& ui, const LessonRunner& runner, float width) {
  const std::string lines =
      widgets::broken_lines(ui.fonts.small, caption_text(runner), width - 2 * ui.px(caption_margin));
  const float high = widgets::height_of(ui.fonts.small, lines);
  return std::max(ui.px(96), std::round(ui.px(caption_top) + high + ui.px(10)));
}

void lesson_caption(Ui& ui, const LessonRunner& runner) {
  const LessonStop* stop = runner.shown();
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float pad = ui.px(caption_margin);
  if (stop == nullptr) return;
  const std::string place = place_text(runner);
  widgets::draw_text(list, ui.fonts.bold, {low.x + pad, low.y + ui.px(8)}, to_u32(ui.colors.text),
                     stop->heading);
  widgets::draw_text(list, ui.fonts.small,
                     {low.x + size.x - pad - widgets::width_of(ui.fonts.small, place), low.y + ui.px(10)},
                     to_u32(ui.colors.quiet), place);
  widgets::draw_text(list, ui.fonts.small, {low.x + pad, low.y + ui.px(caption_top)}, to_u32(ui.colors.text),
                     widgets::broken_lines(ui.fonts.small, caption_text(runner), size.x - 2 * pad));
}

void lesson_list(Ui& ui, std::span<const std::uint32_t> textures) {
  const auto& all = bundled_lessons();
  if (!all) return widgets::quiet_text(ui, all.error().line(), true);
  ImGui::BeginChild("lessons", {0, 0});
  constexpr float high = 60, picture_high = 52, picture_wide = 1.6f * picture_high,
                  text_x = 54 + picture_wide;
  for (std::size_t i = 0; i < all->size(); ++i) {
    const Lesson& lesson = (*all)[i];
    widgets::Row row(ui, high);
    if (row.button(static_cast<std::size_t>(lesson.number))) ui.commands.post("lesson", {lesson.name});
    if (row.hovered()) row.link();
    const std::string number = std::to_string(lesson.number);
    widgets::draw_text(row.list, ui.fonts.mono, {row.at.x + ui.px(12), row.at.y + ui.px(22)},
                       to_u32(ui.colors.quiet), number);
    if (i < textures.size() && textures[i] != 0) {
      const ImVec2 at{row.at.x + ui.px(42), row.at.y + ui.px(4)};
      row.list.AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(textures[i])), at,
                               {at.x + ui.px(picture_wide), at.y + ui.px(picture_high)}, {0, 0}, {1, 1},
                               IM_COL32_WHITE, ui.px(4));
    }
    widgets::draw_text(row.list, ui.fonts.bold, {row.at.x + ui.px(text_x), row.at.y + ui.px(11)},
                       to_u32(ui.colors.text), lesson.title);
    const std::string under = (lesson.figure.empty() ? "" : lesson.figure + "  ·  ") +
                              std::to_string(lesson.stops.size()) + " stops  ·  " +
                              std::to_string(lesson.minutes) + " minutes";
    widgets::draw_text(row.list, ui.fonts.small, {row.at.x + ui.px(text_x), row.at.y + ui.px(32)},
                       to_u32(ui.colors.quiet), under);
    row.value(ui.colors.accent_text, "lesson:" + lesson.name, 0.8f);
    row.below();
  }
  ImGui::EndChild();
}

} // namespace isoscope::panels
