// Gallery, help, palette and about.
#include "app/overlays.h"

#include "app/lesson_cards.h"
#include "app/welcome.h"
#include "base/folded.h"
#include "input/gallery.h"
#include "journal/vocabulary.h"
#include "model/words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cstdint>

namespace isoscope {
namespace {

/// Of the help: one a menu, then the rest.
constexpr auto help_sections = [] {
  std::array<const char*, menu_names.size() + 3> sections{};
  for (std::size_t i = 0; i < menu_names.size(); ++i) sections.at(i) = menu_names.at(i).data();
  sections.at(menu_names.size()) = "No menu";
  sections.at(menu_names.size() + 1) = "Reasons";
  sections.at(menu_names.size() + 2) = "Values";
  return sections;
}();

void heading(Ui& ui, const char* title, const char* note) {
  ImGui::PushFont(ui.fonts.title);
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
  ImGui::SameLine();
  ImGui::SetCursorPos({ImGui::GetWindowContentRegionMax().x - ui.px(28), ui.px(14)});
  if (widgets::icon_button(ui, "close", icon::close)) ui.commands.post("clear");
  widgets::quiet_text(ui, note, true);
  ImGui::Dummy({0, ui.px(6)});
}

void card(Ui& ui, const GalleryEntry& entry, std::uint32_t texture, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(entry.name.data());
  const bool pressed = ImGui::InvisibleButton("card", size);
  ImGui::PopID();
  if (pressed) ui.commands.post("open", {gallery_input(entry.name)});
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + size.x, at.y + size.y};
  const float picture = size.y - ui.px(104);
  list.AddRectFilled(at, end, to_u32(hovered ? ui.colors.hover : ui.colors.raised), ui.px(8));
  list.AddRectFilled(at, {end.x, at.y + picture}, to_u32(ui.colors.ground), ui.px(8),
                     ImDrawFlags_RoundCornersTop);
  if (texture != 0) {
    const float side = std::min(size.x, picture * 1.6f), x = at.x + (size.x - side) / 2;
    list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)),
                  {x, at.y + (picture - side / 1.6f) / 2}, {x + side, at.y + (picture + side / 1.6f) / 2});
  }
  if (hovered) {
    list.AddRect(at, end, to_u32(ui.colors.accent), ui.px(8), 0, ui.px(1.5f));
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  const float pad = ui.px(12);
  widgets::draw_text(list, ui.fonts.bold, {at.x + pad, at.y + picture + ui.px(10)}, to_u32(ui.colors.text),
                     entry.title);
  const std::string delta =
      entry.gives_volume() ? "Ω given" : "δ " + Tolerance{entry.tolerance_percent, true}.text();
  const float extent = widgets::width_of(ui.fonts.mono, delta);
  widgets::draw_text(list, ui.fonts.mono, {end.x - pad - extent, at.y + picture + ui.px(11)},
                     to_u32(ui.colors.quiet), delta);
  const ImVec4 clip{at.x + pad, at.y + picture, end.x - pad + 1, end.y - ui.px(4)};
  const std::string lines = widgets::broken_lines(ui.fonts.small, entry.lesson, size.x - 2 * pad);
  list.AddText(ui.fonts.small, ui.fonts.small->FontSize, {at.x + pad, at.y + picture + ui.px(34)},
               to_u32(ui.colors.quiet), lines.c_str(), nullptr, 0, &clip);
}

void drop_zone(Ui& ui, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("drop", size)) ui.commands.post("open");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool hovered = ImGui::IsItemHovered();
  const ImU32 color = to_u32(hovered ? ui.colors.accent : ui.colors.quiet, hovered ? 1.0f : 0.6f);
  const float dash = ui.px(7);
  for (float x = at.x + ui.px(8); x < at.x + size.x - ui.px(8); x += 2 * dash) {
    const float end = std::min(x + dash, at.x + size.x - ui.px(8));
    list.AddLine({x, at.y}, {end, at.y}, color, ui.px(1.2f));
    list.AddLine({x, at.y + size.y}, {end, at.y + size.y}, color, ui.px(1.2f));
  }
  for (float y = at.y + ui.px(8); y < at.y + size.y - ui.px(8); y += 2 * dash) {
    const float end = std::min(y + dash, at.y + size.y - ui.px(8));
    list.AddLine({at.x, y}, {at.x, end}, color, ui.px(1.2f));
    list.AddLine({at.x + size.x, y}, {at.x + size.x, end}, color, ui.px(1.2f));
  }
  const std::string text =
      std::string(icon::upload) +
      "   Drop a surface, points, a grid, or two surfaces at once; or click to look for them";
  const float width = widgets::width_of(ui.fonts.ui, text);
  widgets::draw_text(list, ui.fonts.ui,
                     {at.x + (size.x - width) / 2, at.y + (size.y - ui.fonts.ui->FontSize) / 2},
                     to_u32(hovered ? ui.colors.text : ui.colors.quiet), text);
}

} // namespace

void Overlays::gallery(Ui& ui) {
  heading(ui, "Gallery",
          "Lessons, and bundled models, each with what it teaches. A click opens it and refinement begins.");
  ImGui::BeginChild("cards", {0, -ui.px(66)});
  constexpr int columns = 3;
  const float gap = ui.px(14),
              width = (ImGui::GetContentRegionAvail().x - (columns - 1) * gap - ui.px(12)) / columns;
  const ImVec2 size{width, ui.px(226)};
  int column = 0;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  panels::lesson_cards(ui, lesson_textures);
  for (std::size_t i = 0; i < isoscope::gallery().size(); ++i) {
    card(ui, isoscope::gallery()[i], i < thumbnails_.textures.size() ? thumbnails_.textures[i] : 0, size);
    if (++column % columns != 0) ImGui::SameLine(0, gap);
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  ImGui::Dummy({0, ui.px(2)});
  drop_zone(ui, {ImGui::GetContentRegionAvail().x, ui.px(48)});
}

void Overlays::help(Ui& ui) {
  heading(ui, "Help",
          "Every command with its key; scripts use the name on the left. In the view: left-drag turns, "
          "Shift-left- or right-drag moves, the wheel zooms to the cursor, a click selects, a double-click "
          "sets the centre.");
  ImGui::SetNextItemWidth(ui.px(230));
  ImGui::InputTextWithHint("##help", (std::string(icon::search) + "  filter").c_str(), query_.data(),
                           query_.size());
  {
    const widgets::Font font(ui.fonts.small);
    for (std::size_t i = 0; i < help_sections.size(); ++i) {
      widgets::beside_or_below(ui, help_sections.at(i), i == 0 ? 14 : 4);
      if (widgets::plain_button(ui, help_sections.at(i), true, 0, ui.px(24))) section_ = static_cast<int>(i);
    }
  }
  ImGui::BeginChild("commands", {0, 0});
  ImGui::PushFont(ui.fonts.small);
  const float wide = ImGui::GetContentRegionAvail().x, name_width = std::min(ui.px(250), 0.33f * wide),
              key_width = std::min(ui.px(130), 0.17f * wide);
  if (ImGui::BeginTable("table", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) {
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, name_width);
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, key_width);
    ImGui::TableSetupColumn("help", ImGuiTableColumnFlags_WidthStretch);
    std::optional<std::size_t> section; // whose heading is still to come, with its first row
    const auto heading_row = [&](std::size_t i) {
      ImGui::TableNextRow(0, ui.px(30));
      ImGui::TableNextColumn();
      if (section_ == static_cast<int>(i)) {
        ImGui::SetScrollHereY(0);
        section_ = -1;
      }
      ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1, to_u32(ui.colors.accent, 0.14f));
      ImGui::SetCursorPosY(ImGui::GetCursorPosY() + ui.px(6));
      widgets::bold_text(ui, help_sections.at(i));
    };
    // Whether it is drawn.
    const auto row = [&](const std::string& name, const std::string& key, std::string_view text) {
      if (!contains_folded(name + " " + key + " " + std::string(text), query_.data())) return false;
      if (section) heading_row(*std::exchange(section, std::nullopt));
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::PushFont(ui.fonts.mono);
      widgets::wrapped_text(name);
      ImGui::TableNextColumn();
      ImGui::PushStyleColor(ImGuiCol_Text, to_vec(ui.colors.accent_text));
      ImGui::TextUnformatted(key.c_str());
      ImGui::PopStyleColor();
      ImGui::PopFont();
      ImGui::TableNextColumn();
      widgets::wrapped_text(text);
      return true;
    };
    const auto keys_of = [](const Command& command) {
      std::string keys;
      for (const Chord& chord : command.keys) keys += (keys.empty() ? "" : ", ") + text(chord);
      return keys;
    };
    for (std::size_t m = 0; m <= menu_names.size(); ++m) {
      section = m;
      // Those without a menu stand together.
      const std::string_view menu = m < menu_names.size() ? menu_names.at(m) : std::string_view();
      for (const Command& c : ui.table.all())
        if (c.menu == menu) row(c.name + (c.usage.empty() ? "" : " " + c.usage), keys_of(c), c.help);
    }
    section = menu_names.size() + 1;
    for (const ReasonWords& style : reason_table) {
      if (!rejects(style.value) || !row(std::string(style.name), std::string(style.title), style.help))
        continue;
      const ImVec2 low = ImGui::GetItemRectMin();
      widgets::glyph(ui, {low.x - key_width - ui.px(16), low.y + ui.px(7)}, 4.5f, style.color, style.shape);
    }
    section = menu_names.size() + 2;
    for (const NamedValue& value : model_.values.all())
      row((value.set ? "set " : "expect ") + value.name, value.get(), value.help);
    ImGui::EndTable();
  }
  ImGui::PopFont();
  ImGui::EndChild();
}

void Overlays::palette(Ui& ui) {
  if (shown_ != Overlay::palette || !completed_.empty()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  // A completed text leaves the cursor at its end.
  const auto at_end = [](ImGuiInputTextCallbackData* data) {
    auto& wanted = *static_cast<std::string*>(data->UserData);
    if (wanted.empty()) return 0;
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, wanted.c_str());
    wanted.clear();
    return 0;
  };
  if (ImGui::InputTextWithHint("##palette",
                               (std::string(icon::search) + "  a command, an event, an element, a setting, a "
                                                            "lesson")
                                   .c_str(),
                               query_.data(), query_.size(), ImGuiInputTextFlags_CallbackAlways, at_end,
                               &completed_))
    chosen_ = 0;
  if (std::string(query_.data()) != found_for_ || shown_ != Overlay::palette) {
    found_for_ = query_.data();
    found_ = palette_entries(model_, found_for_);
  }
  const int count = static_cast<int>(found_.size());
  bool moved = false;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow)))
    chosen_ = std::min(chosen_ + 1, count - 1), moved = true;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow)))
    chosen_ = std::max(chosen_ - 1, 0), moved = true;
  const bool entered = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
  ImGui::BeginChild("found", {0, 0});
  if (found_.empty()) widgets::quiet_text(ui, "Nothing says this.");
  for (int i = 0; i < count; ++i) {
    const PaletteEntry& entry = found_[static_cast<std::size_t>(i)];
    widgets::Row row(ui, 44);
    const bool pressed = row.button(static_cast<std::size_t>(i)), lit = i == chosen_;
    if (lit && moved) ImGui::SetScrollHereY(0.6f);
    if (lit || row.hovered()) row.ground(lit ? ui.colors.accent : ui.colors.hover, lit ? 0.18f : 1.0f);
    const float strength = entry.enabled ? 1.0f : 0.5f;
    const ImVec2 at = row.at;
    ImDrawList& list = row.list;
    if (entry.icon)
      widgets::draw_text(list, ui.fonts.ui, {at.x + ui.px(12), at.y + ui.px(14)},
                         to_u32(ui.colors.quiet, strength), entry.icon);
    const float room = row.width - ui.px(170);
    {
      const widgets::Font font(ui.fonts.ui);
      widgets::draw_text(list, ui.fonts.ui, {at.x + ui.px(40), at.y + ui.px(4)},
                         to_u32(ui.colors.text, strength), widgets::fitted(entry.title, room));
    }
    const widgets::Font font(ui.fonts.small);
    widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(40), at.y + ui.px(23)},
                       to_u32(ui.colors.quiet, strength), widgets::fitted(entry.help, room));
    if (!entry.key.empty() || !entry.enabled) {
      // Not by paleness alone: what cannot be done now says so where its key stands.
      const std::string key =
          entry.enabled ? entry.key : (entry.key.empty() ? "" : entry.key + "  ") + "not now";
      const float extent = widgets::width_of(ui.fonts.mono, key);
      widgets::draw_text(list, ui.fonts.mono, {at.x + row.width - extent - ui.px(12), at.y + ui.px(14)},
                         to_u32(ui.colors.accent_text, strength), key);
    }
    if (!entry.enabled || !(pressed || (entered && i == chosen_))) continue;
    if (!entry.complete.empty()) {
      completed_ = entry.complete;
      continue;
    }
    ui.commands.post("clear");
    ui.commands.post(entry.call.name, entry.call.arguments);
  }
  ImGui::EndChild();
}

void Overlays::about(Ui& ui) {
  heading(ui, "Isoscope",
          "A visualizer and debugger for Isotopic Approximation within a Tolerance Volume, after Mandad, "
          "Cohen-Steiner and Alliez, SIGGRAPH 2015.");
  const auto paragraph = [&](const char* text) {
    widgets::wrapped_text(text);
    ImGui::Dummy({0, ui.px(4)});
  };
  paragraph("Free software under the GNU General Public License, version 3 or later.");
  paragraph("The method is described in the patent application FR 3039686 A1 of its authors' institute.");
  paragraph("Built on CGAL, oneTBB, GLFW, Dear ImGui, GLM, glad, stb and nlohmann-json. Fonts: Inter and "
            "JetBrains Mono (SIL Open Font License), Font Awesome (SIL Open Font License).");
}

void Overlays::bookmarks(Ui& ui) {
  heading(
      ui, "Bookmarks",
      "Steps with their view and selection: the slides of a talk, in this order. PageDown and PageUp turn "
      "them.");
  bookmarks_.draw(ui, model_.talk);
}

void Overlays::draw(Ui& ui, ImVec2 size) {
  const Overlay now = ui.window.overlay;
  if (now != shown_) {
    query_.fill(0);
    chosen_ = 0;
  }
  if (shown_ == Overlay::welcome && now != shown_) ui.window.settings.greeted = true;
  if (now == Overlay::none) {
    shown_ = now;
    return;
  }
  ImVec2 extent{std::min(size.x - ui.px(60), ui.px(980)), std::min(size.y - ui.px(60), ui.px(760))};
  if (now == Overlay::palette)
    extent = {std::min(size.x - ui.px(60), ui.px(620)), std::min(size.y - ui.px(120), ui.px(460))};
  if (now == Overlay::welcome) extent.x = std::min(size.x - ui.px(60), ui.px(900));
  if (now == Overlay::about || now == Overlay::pictures) extent.x = std::min(size.x - ui.px(60), ui.px(560));
  if (now == Overlay::files || now == Overlay::bookmarks || now == Overlay::lessons)
    extent = {std::min(size.x - ui.px(60), ui.px(860)), std::min(size.y - ui.px(60), ui.px(560))};
  // These are as high as what stands in them, which their first frame, unseen, tells.
  const bool measured = now == Overlay::welcome || now == Overlay::about || now == Overlay::pictures;
  if (now != shown_) needed_ = 0;
  const bool unseen = measured && needed_ <= 0;
  if (measured && needed_ > 0) extent.y = std::min(needed_, size.y - ui.px(20));
  const float y = now == Overlay::palette ? ui.px(64) : (size.y - extent.y) / 2;
  const ImVec2 low{std::round((size.x - extent.x) / 2), std::round(y)};

  // One window over everything: a veil that a click lifts, and the panel as its child.
  constexpr ImGuiWindowFlags fixed =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(size);
  if (now != shown_) ImGui::SetNextWindowFocus();
  ImGui::PushStyleColor(ImGuiCol_WindowBg, to_vec(ui.colors.ground, 0.66f));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_vec(ui.colors.panel));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(20), ui.px(16)});
  ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, ui.px(10));
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 1);
  ImGui::Begin("##overlay", nullptr, fixed);
  const bool outside = !ImGui::IsMouseHoveringRect(low, {low.x + extent.x, low.y + extent.y}, false);
  if (outside && ImGui::IsMouseClicked(0) && now == shown_) ui.commands.post("clear");
  ImGui::SetCursorScreenPos(low);
  if (unseen) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0);
  ImGui::BeginChild("panel", extent, true, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 0);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_vec(ui.colors.panel, 0));
  switch (now) {
  case Overlay::gallery:
    gallery(ui);
    break;
  case Overlay::files:
    files_.draw(ui);
    break;
  case Overlay::help:
    help(ui);
    break;
  case Overlay::palette:
    palette(ui);
    break;
  case Overlay::about:
    about(ui);
    break;
  case Overlay::bookmarks:
    bookmarks(ui);
    break;
  case Overlay::pictures:
    heading(ui, "Pictures and films", "The view without panels, as it is drawn now; lines keep their look.");
    pictures_.draw(ui, model_.exports);
    break;
  case Overlay::welcome:
    heading(ui, "Isoscope",
            "A coarse mesh with the right topology, found inside a tolerance volume. Where to begin?");
    panels::welcome(ui, thumbnails_, lesson_textures);
    break;
  case Overlay::lessons:
    heading(ui, "Lessons",
            "Prepared scenes with questions and things to try. PageDown and PageUp, or Enter and Backspace, "
            "turn the stops; P shows one to an audience.");
    panels::lesson_list(ui, lesson_textures);
    break;
  case Overlay::none:
    break;
  }
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  needed_ = ImGui::GetCursorPosY() + ImGui::GetScrollY() - ImGui::GetStyle().ItemSpacing.y + ui.px(16);
  ImGui::EndChild();
  if (unseen) ImGui::PopStyleVar();
  ImGui::End();
  ImGui::PopStyleVar(3);
  ImGui::PopStyleColor(2);
  shown_ = now;
}

} // namespace isoscope
