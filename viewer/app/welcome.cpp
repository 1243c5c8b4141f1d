// Cards and marks.
#include "app/welcome.h"

#include "input/gallery.h"
#include "lesson/lesson.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <string>

namespace isoscope::panels {
namespace {

struct Way {
  const char* title;
  const char* text;
  const char* icon;
  std::string_view model; ///< whose thumbnail is its picture, where it is no lesson
  const char* command;
  const char* argument;
};

constexpr std::array<Way, 3> ways{{
    {"Watch it work", "From a tolerance volume to a proven coarse mesh, stage by stage, in six minutes.",
     icon::play, "", "lesson", "whole-way"},
    {"Why did it fail?", "One edge, and every gate that may stop its collapse: the way through the debugger.",
     icon::search, "", "lesson", "why-a-collapse-failed"},
    {"Your own model", "A surface, points, a grid or two surfaces: drop them here, or look for them.",
     icon::upload, "noisy-sphere", "open", ""},
}};

struct Mark {
  const char* id;
  const char* text;
};

constexpr std::array<Mark, coach_mark_count> marks{{
    {"##mark-view",
     "Space lets the run play, Right and Left step through it. Drag turns the scene, a click selects."},
    {"##mark-timeline", "Each mark is a decision, with its reason. Click one: the scene goes there."},
    {"##mark-inspector",
     "What is selected stands here: its numbers beside their limits, and what may be asked of it."},
}};

/// The texture of the entry of that name.
template <class All>
std::uint32_t named(const All& all, std::span<const std::uint32_t> textures, std::string_view name) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.name == name; });
  const auto i = static_cast<std::size_t>(at - all.begin());
  return i < textures.size() ? textures[i] : 0;
}

std::uint32_t picture_for(const Way& way, const Thumbnails& thumbnails,
                          std::span<const std::uint32_t> lessons) {
  if (!way.model.empty()) return named(gallery(), thumbnails.textures, way.model);
  const auto& all = bundled_lessons();
  return all ? named(*all, lessons, way.argument) : 0;
}

void way_card(Ui& ui, const Way& way, std::uint32_t texture, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton(way.title, size)) {
    ui.commands.post("clear");
    ui.commands.post(way.command, *way.argument ? Arguments{way.argument} : Arguments{});
  }
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + size.x, at.y + size.y};
  const float picture = size.x / 1.6f, pad = ui.px(14);
  list.AddRectFilled(at, end, to_u32(hovered ? ui.colors.hover : ui.colors.raised), ui.px(8));
  list.AddRectFilled(at, {end.x, at.y + picture}, to_u32(ui.colors.ground), ui.px(8),
                     ImDrawFlags_RoundCornersTop);
  if (texture != 0) {
    list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), at,
                  {end.x, at.y + picture});
  } else {
    const float width = widgets::width_of(ui.fonts.ui, way.icon) * 3;
    list.AddText(ui.fonts.ui, 3 * ui.fonts.ui->FontSize,
                 {at.x + (size.x - width) / 2, at.y + picture / 2 - 1.5f * ui.fonts.ui->FontSize},
                 to_u32(ui.colors.quiet), way.icon);
  }
  if (hovered) list.AddRect(at, end, to_u32(ui.colors.accent), ui.px(8), 0, ui.px(1.5f));
  widgets::draw_text(list, ui.fonts.title, {at.x + pad, at.y + picture + ui.px(12)}, to_u32(ui.colors.text),
                     way.title);
  widgets::draw_text(list, ui.fonts.ui, {at.x + pad, at.y + picture + ui.px(46)}, to_u32(ui.colors.quiet),
                     widgets::broken_lines(ui.fonts.ui, way.text, size.x - 2 * pad));
}

} // namespace

void welcome(Ui& ui, const Thumbnails& thumbnails, std::span<const std::uint32_t> lessons) {
  constexpr auto count = static_cast<float>(ways.size());
  const float gap = ui.px(14), width = (ImGui::GetContentRegionAvail().x - (count - 1) * gap) / count;
  const ImVec2 size{width, width / 1.6f + ui.px(120)};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    way_card(ui, ways[i], picture_for(ways[i], thumbnails, lessons), size);
  }
  ImGui::Dummy({0, ui.px(4)});
  if (widgets::plain_button(ui, "All lessons")) ui.commands.post("lesson");
  ImGui::SameLine(0, gap);
  if (widgets::plain_button(ui, "Gallery")) ui.commands.post("gallery");
}

void coach_marks(Ui& ui, const std::array<CoachPlace, coach_mark_count>& places) {
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize;
  std::uint8_t& closed = ui.window.settings.coach_closed;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const CoachPlace& place = places[i];
    if ((closed >> i & 1u) != 0 || place.size.x <= 0 || place.size.y <= 0) continue;
    const float wide = std::min(ui.px(270), place.size.x - ui.px(24));
    // At the lower rim, so that it does not lie on what it speaks of.
    ImGui::SetNextWindowPos({place.low.x + place.size.x / 2, place.low.y + place.size.y - ui.px(10)},
                            ImGuiCond_Always, {0.5f, 1});
    ImGui::SetNextWindowSizeConstraints({wide, 0}, {wide, place.size.y});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, to_vec(ui.colors.accent));
    ImGui::PushStyleColor(ImGuiCol_Text, to_vec(ui.colors.on_accent));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(14), ui.px(10)});
    ImGui::Begin(marks[i].id, nullptr, flags);
    widgets::wrapped_text(marks[i].text);
    ImGui::PushStyleColor(ImGuiCol_Button, to_vec(ui.colors.on_accent, 0.15f));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, to_vec(ui.colors.on_accent, 0.3f));
    if (ImGui::Button("Got it")) closed |= static_cast<std::uint8_t>(1u << i);
    ImGui::PopStyleColor(2);
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor(2);
  }
}

} // namespace isoscope::panels
