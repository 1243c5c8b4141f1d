// The sentence below the scene, where one is in the run, and the slide's note.
#include "talk/talk.h"

#include "journal/vocabulary.h"
#include "model/words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>

namespace isoscope::panels {
namespace {

/// Stages as stripes, moments and bookmarks as marks, and how far the head is.
void progress_line(const Ui& ui, const Bookmarks& bookmarks, ImVec2 low, ImVec2 size) {
  const WindowState& m = ui.window;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float steps = static_cast<float>(std::max<Step>(m.live_step(), 1));
  const auto x = [&](Step step) { return low.x + size.x * std::min(static_cast<float>(step) / steps, 1.0f); };
  const float head = x(m.transport.step());
  for (const JournalIndex::StageSpan& span : m.index.stages()) {
    const float begin = x(span.begin), end = x(span.open ? m.live_step() : span.end);
    const Rgb color = stage_color(ui.theme, span.stage);
    list.AddRectFilled({begin, low.y}, {end, low.y + size.y}, to_u32(color, 0.25f));
    if (head > begin)
      list.AddRectFilled({begin, low.y}, {std::min(head, end), low.y + size.y}, to_u32(color));
  }
  for (const Bookmark& b : bookmarks.all()) {
    const float at = x(b.step), r = ui.px(4);
    list.AddTriangleFilled({at - r, low.y - r}, {at + r, low.y - r}, {at, low.y + size.y},
                           to_u32(ui.colors.accent));
  }
  list.AddRectFilled({head - ui.px(1), low.y - ui.px(2)}, {head + ui.px(1), low.y + size.y + ui.px(2)},
                     to_u32(ui.colors.text));
}

constexpr float above_units = 15, below_units = 9; ///< room around the sentences

} // namespace

PresenterBar::PresenterBar(const Ui& ui, const Talk& talk, float width) : talk_(talk) {
  const WindowState& m = ui.window;
  place_ = grouped(m.transport.step()) + " / " + grouped(m.live_step());
  if (m.playing()) {
    const double speed = m.transport.speed();
    place_ += speed == Transport::automatic ? "" : "  " + widgets::speed_text(speed);
  }
  text_x_ = ui.px(36);
  place_x_ = width - ui.px(48) - widgets::width_of(ui.fonts.small, place_);
  what_ = widgets::broken_lines(ui.fonts.ui, talk.caption(), place_x_ - text_x_);
  why_ = widgets::broken_lines(ui.fonts.small, talk.caption_why(), place_x_ - text_x_);
  what_high_ = widgets::height_of(ui.fonts.ui, what_);
  why_high_ = widgets::height_of(ui.fonts.small, why_);
}

// Room for two lines and the reason: the view keeps its size from step to step, but for the longest texts.
float PresenterBar::height(const Ui& ui) const {
  const float usual = 2 * ui.fonts.ui->FontSize + ui.fonts.small->FontSize;
  return std::round(std::max(what_high_ + why_high_, usual) + ui.px(above_units) + ui.px(below_units));
}

void PresenterBar::draw(const Ui& ui) const {
  const WindowState& m = ui.window;
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  progress_line(ui, talk_.bookmarks, {low.x, low.y + ui.px(5)}, {size.x, ui.px(4)});
  const float room = size.y - ui.px(above_units) - ui.px(below_units);
  const float top = low.y + ui.px(above_units) + std::max(0.0f, (room - what_high_ - why_high_) / 2);
  const float line = top + ui.fonts.ui->FontSize / 2;

  const float place_x = low.x + place_x_ + ui.px(34);
  widgets::draw_text(list, ui.fonts.small, {place_x, line - ui.fonts.small->FontSize / 2},
                     to_u32(ui.colors.quiet), place_);
  widgets::draw_text(list, ui.fonts.ui, {place_x - ui.px(24), line - ui.fonts.ui->FontSize / 2},
                     to_u32(ui.colors.quiet), m.playing() ? icon::play : icon::pause);

  const auto kept = m.state(); // the event may be its own
  const Event* event = talk_.caption_event();
  const bool rejected = event != nullptr && event->kind == EventKind::rejection;
  const Rgb color = event == nullptr ? ui.colors.quiet
                    : rejected       ? words(event->reason).color
                    : event->condition != Condition::none
                        ? condition_color(ui.theme, static_cast<int>(event->condition))
                        : stage_color(ui.theme, event->stage);
  widgets::glyph(ui, {low.x + ui.px(20), line}, 6, color,
                 rejected ? words(event->reason).shape : MarkerShape::disc);
  widgets::draw_text(list, ui.fonts.ui, {low.x + text_x_, top}, to_u32(ui.colors.text), what_);
  widgets::draw_text(list, ui.fonts.small, {low.x + text_x_, top + what_high_}, to_u32(ui.colors.quiet),
                     why_);
}

void slide_title(const Ui& ui, const Bookmarks& bookmarks, ImVec2 low, float width) {
  const auto current = bookmarks.current();
  if (!current) return;
  const Bookmark& b = bookmarks.all()[*current];
  if (b.step != ui.window.transport.step()) return;
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const std::string number = std::to_string(*current + 1) + " / " + std::to_string(bookmarks.size());
  ImGui::PushFont(ui.fonts.title);
  const std::string note = widgets::fitted(b.note, width - ui.px(44));
  ImGui::PopFont();
  // A ground of its own: the scene behind may be as bright as the text.
  const float wide =
      std::max(widgets::width_of(ui.fonts.small, number), widgets::width_of(ui.fonts.title, note));
  list.AddRectFilled({low.x + ui.px(10), low.y + ui.px(10)},
                     {low.x + ui.px(34) + wide, low.y + ui.px(note.empty() ? 36 : 62)},
                     to_u32(ui.colors.ground, 0.78f), ui.px(8));
  const float x = low.x + ui.px(22);
  widgets::draw_text(list, ui.fonts.small, {x, low.y + ui.px(15)}, to_u32(ui.colors.quiet), number);
  if (!note.empty())
    widgets::draw_text(list, ui.fonts.title, {x, low.y + ui.px(32)}, to_u32(ui.colors.text), note);
}

} // namespace isoscope::panels
