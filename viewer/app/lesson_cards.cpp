// Cards of equal width.
#include "app/lesson_cards.h"

#include "lesson/lesson.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <string>

namespace isoscope::panels {
namespace {

struct LessonCard {
  std::string id, title, note;
  const char* icon; ///< where there is no picture
  std::uint32_t texture;
};

/// Titles have room for so many lines, each of that height.
constexpr int title_lines = 2;
constexpr float title_line = 18;

bool pressed_card(const Ui& ui, const LessonCard& card, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(card.id.c_str(), size);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + size.x, at.y + size.y};
  const float picture = size.x / 1.6f, pad = ui.px(10);
  list.AddRectFilled(at, end, to_u32(hovered ? ui.colors.hover : ui.colors.raised), ui.px(8));
  list.AddRectFilled(at, {end.x, at.y + picture}, to_u32(ui.colors.ground), ui.px(8),
                     ImDrawFlags_RoundCornersTop);
  if (card.texture != 0) {
    list.AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(card.texture)), at,
                         {end.x, at.y + picture}, {0, 0}, {1, 1}, IM_COL32_WHITE, ui.px(8),
                         ImDrawFlags_RoundCornersTop);
  } else {
    const float big = 2 * ui.fonts.ui->FontSize, width = 2 * widgets::width_of(ui.fonts.ui, card.icon);
    list.AddText(ui.fonts.ui, big, {at.x + (size.x - width) / 2, at.y + (picture - big) / 2},
                 to_u32(ui.colors.quiet), card.icon);
  }
  if (hovered) list.AddRect(at, end, to_u32(ui.colors.accent), ui.px(8), 0, ui.px(1.5f));
  const auto text = [&](ImFont* font, float y, Rgb color, const std::string& words, int lines) {
    const widgets::Font used(font);
    widgets::draw_text(list, font, {at.x + pad, at.y + picture + ui.px(y)}, to_u32(color),
                       widgets::fitted(words, size.x - 2 * pad, lines));
  };
  text(ui.fonts.bold, 7, ui.colors.text, card.title, title_lines);
  text(ui.fonts.small, 27 + title_line * (title_lines - 1), ui.colors.quiet, card.note, 1);
  return pressed;
}

} // namespace

void lesson_cards(Ui& ui, std::span<const std::uint32_t> textures) {
  const auto& lessons = bundled_lessons();
  if (!lessons) return;
  constexpr std::size_t columns = 5;
  const float gap = ui.px(14);
  const float width = (ImGui::GetContentRegionAvail().x - gap * (columns - 1) - ui.px(12)) / columns;
  const ImVec2 size{width, std::round(width / 1.6f + ui.px(50 + title_line * (title_lines - 1)))};
  for (std::size_t i = 0; i < std::min(columns - 1, lessons->size()); ++i) {
    const Lesson& lesson = (*lessons)[i];
    const std::string note =
        std::to_string(lesson.stops.size()) + " stops, " + std::to_string(lesson.minutes) + " minutes";
    if (pressed_card(
            ui, {lesson.name, lesson.title, note, icon::graduation, i < textures.size() ? textures[i] : 0},
            size))
      ui.commands.post("lesson", {lesson.name});
    ImGui::SameLine(0, gap);
  }
  if (pressed_card(
          ui,
          {"all lessons", "All lessons", std::to_string(lessons->size()) + " of them", icon::graduation, 0},
          size))
    ui.commands.post("lesson");
}

} // namespace isoscope::panels
