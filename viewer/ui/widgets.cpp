// The shared pieces.
#include "ui/widgets.h"

#include "model/words.h"
#include "ui/icons.h"
#include "ui/word_wrap.h"

#include <algorithm>
#include <cmath>

namespace isoscope::widgets {
namespace {

void text(std::string_view s) {
  ImGui::TextUnformatted(s.data(), s.data() + s.size());
}

bool hovered_at_rest() {
  return ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) &&
         !ImGui::IsMouseDown(ImGuiMouseButton_Left);
}

/// A decimal number without the zeros at its end.
std::string trimmed(std::string number) {
  if (number.find('.') == std::string::npos || number.find('e') != std::string::npos) return number;
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number;
}

/// The time that the last item has been hovered, kept in the window's storage.
double hover_seconds() {
  const ImGuiID id = ImGui::GetID("hover-clock");
  ImGuiStorage* store = ImGui::GetStateStorage();
  const ImVec2 at = ImGui::GetItemRectMin();
  const int key = static_cast<int>(at.x) * 7919 + static_cast<int>(at.y) + 1;
  const float now = static_cast<float>(ImGui::GetTime());
  if (store->GetInt(id) != key) {
    store->SetInt(id, key);
    store->SetFloat(id + 1, now);
  }
  return static_cast<double>(now - store->GetFloat(id + 1));
}

} // namespace

std::string speed_text(double speed) {
  if (speed == Transport::automatic) return "auto";
  if (speed >= Transport::unlimited) return "max";
  if (speed == 0.25) return "¼×";
  if (speed == 0.5) return "½×";
  return grouped(static_cast<std::size_t>(speed)) + "×";
}

ImVec2 text_size(std::string_view s) {
  return ImGui::CalcTextSize(s.data(), s.data() + s.size());
}

float width_of(const ImFont* font, std::string_view s) {
  return font->CalcTextSizeA(font->FontSize, 1e9f, 0, s.data(), s.data() + s.size()).x;
}

void draw_text(ImDrawList& list, ImFont* font, ImVec2 at, ImU32 color, std::string_view s) {
  list.AddText(font, font->FontSize, {std::round(at.x), std::round(at.y)}, color, s.data(),
               s.data() + s.size());
}

std::string fitted(std::string_view s, float width) {
  if (text_size(s).x <= width) return std::string(s);
  std::string cut(s);
  while (!cut.empty() && text_size(cut + "…").x > width) {
    do {
      const auto last = static_cast<unsigned char>(cut.back());
      cut.pop_back();
      if ((last & 0xC0) != 0x80) break;
    } while (!cut.empty());
  }
  return cut + "…";
}

void wrapped_text(std::string_view s, float width) {
  text(isoscope::broken_lines(s, width > 0 ? width : ImGui::GetContentRegionAvail().x,
                              [](std::string_view part) { return text_size(part).x; }));
}

std::string broken_lines(const ImFont* font, std::string_view s, float width) {
  return isoscope::broken_lines(s, width, [font](std::string_view part) { return width_of(font, part); });
}

float height_of(const ImFont* font, const std::string& lines) {
  if (lines.empty()) return 0;
  return font->CalcTextSizeA(font->FontSize, 1e9f, 0, lines.data(), lines.data() + lines.size()).y;
}

std::string fitted(std::string_view s, float width, int lines) {
  std::string broken;
  for (; lines > 1 && text_size(s).x > width; --lines) {
    const std::size_t end = line_end(s, width, [](std::string_view part) { return text_size(part).x; });
    broken += fitted(s.substr(0, end), width) + '\n';
    s.remove_prefix(std::min(end + 1, s.size()));
  }
  return broken + fitted(s, width);
}

Row::Row(const Ui& ui, float high_units, float wide)
    : at(ImGui::GetCursorScreenPos()),
      width(wide > 0 ? wide : std::max(ImGui::GetContentRegionAvail().x, 1.0f)), high(ui.px(high_units)),
      list(*ImGui::GetWindowDrawList()), ui_(ui) {}

bool Row::button(const char* id) {
  const bool pressed = ImGui::InvisibleButton(id, {width, high});
  hovered_ = ImGui::IsItemHovered();
  return pressed;
}

bool Row::button(std::size_t id) {
  ImGui::PushID(static_cast<int>(id));
  const bool pressed = button("row");
  ImGui::PopID();
  return pressed;
}

void Row::ground(Rgb color, float alpha, float margin) const {
  const float beyond = ui_.px(margin);
  list.AddRectFilled({at.x - beyond, at.y}, {at.x + width + beyond, at.y + high}, to_u32(color, alpha),
                     ui_.px(4));
}

void Row::link() const {
  if (!hovered_) return;
  ground(ui_.colors.hover, 1, 4);
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

void Row::text(ImFont* font, float x, Rgb color, std::string_view s, float alpha) const {
  draw_text(list, font, {at.x + ui_.px(x), y(font)}, to_u32(color, alpha), s);
}

void Row::fitted(ImFont* font, float x, Rgb color, std::string_view s, float room, float alpha) const {
  const Font present(font);
  text(font, x, color, widgets::fitted(s, room), alpha);
}

void Row::step(Step step) const {
  const std::string number = grouped(step);
  draw_text(list, ui_.fonts.mono, {at.x + ui_.px(64) - width_of(ui_.fonts.mono, number), y(ui_.fonts.small)},
            to_u32(ui_.colors.quiet), number);
}

float Row::value(Rgb color, std::string_view s, float alpha) const {
  const float extent = width_of(ui_.fonts.mono, s);
  draw_text(list, ui_.fonts.mono, {at.x + width - extent, y(ui_.fonts.mono)}, to_u32(color, alpha), s);
  return extent;
}

void Row::pair(Rgb label_color, std::string_view label, Rgb color, std::string_view shown) const {
  const float gap = ui_.px(10), label_room = width - width_of(ui_.fonts.small, label) - gap;
  const Font mono(ui_.fonts.mono);
  const float taken = value(color, widgets::fitted(shown, std::max(label_room, 0.6f * width)));
  fitted(ui_.fonts.small, 0, label_color, label, std::max(width - taken - gap, 1.0f));
}
void Row::glyph(float x, Rgb color, MarkerShape shape, float radius) const {
  widgets::glyph(ui_, {at.x + ui_.px(x), at.y + high / 2}, radius, color, shape);
}

void Row::verdict(float x, bool good) const {
  glyph(x, good ? ui_.colors.good : ui_.colors.bad_text, good ? MarkerShape::disc : MarkerShape::cross);
}

void tip(const Ui& ui, std::string_view title, std::string_view body) {
  if (!hovered_at_rest()) return;
  constexpr double delay = 0.5;
  if (hover_seconds() < delay) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(8)});
  ImGui::BeginTooltip();
  const float width = ui.px(310);
  if (!title.empty()) {
    const Font font(ui.fonts.bold);
    wrapped_text(title, width);
  }
  if (!body.empty()) {
    const Font drawn_in(ui.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, to_vec(ui.colors.text, 0.85f));
    wrapped_text(body, width);
    ImGui::PopStyleColor();
  }
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void command_tip(const Ui& ui, std::string_view name) {
  const Command* command = ui.table.find(name);
  if (command == nullptr) return;
  std::string title = command->title;
  if (!command->keys.empty()) title += "   " + isoscope::text(command->keys.front());
  tip(ui, title, command->help);
}

bool icon_button(const Ui& ui, const char* id, const char* icon, bool lit, bool enabled, float width) {
  const float side = ui.px(28);
  const ImVec2 size{width > 0 ? width : side, side};
  ImGui::PushID(id);
  ImGui::BeginDisabled(!enabled);
  const bool pressed = ImGui::InvisibleButton("button", size);
  ImGui::EndDisabled();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool hovered = enabled && ImGui::IsItemHovered();
  if (lit)
    list.AddRectFilled(low, high, to_u32(ui.colors.accent, hovered ? 0.30f : 0.20f), ui.px(5));
  else if (hovered)
    list.AddRectFilled(low, high, to_u32(ui.colors.hover), ui.px(5));
  const Rgb color = lit ? ui.colors.accent_text : ui.colors.text;
  const ImVec2 extent = text_size(icon);
  draw_text(list, ImGui::GetFont(), {low.x + (size.x - extent.x) / 2, low.y + (size.y - extent.y) / 2},
            to_u32(color, enabled ? (hovered || lit ? 1.0f : 0.85f) : 0.3f), icon);
  ImGui::PopID();
  return pressed && enabled;
}

void command_button(const Ui& ui, std::string_view name, const char* icon, Arguments arguments) {
  const Command* command = ui.table.find(name);
  if (command == nullptr) return;
  const bool enabled = command->is_enabled();
  const bool lit = command->is_checked();
  const std::string id(name);
  if (icon_button(ui, id.c_str(), icon ? icon : command->icon, lit, enabled))
    ui.commands.post(id, std::move(arguments));
  command_tip(ui, name);
}

void key_button(const Ui& ui, std::string_view name, float width) {
  const Command* command = ui.table.find(name);
  if (command == nullptr || command->keys.empty()) return;
  const bool enabled = command->is_enabled();
  const bool lit = command->is_checked();
  const std::string id(name),
      label = std::string(command->icon) + " " + isoscope::text(command->keys.front());
  ImGui::PushFont(ui.fonts.small);
  if (icon_button(ui, id.c_str(), label.c_str(), lit, enabled, width)) ui.commands.post(id);
  ImGui::PopFont();
  command_tip(ui, name);
}

bool primary_button(const Ui& ui, const char* label, bool enabled, float width) {
  ImGui::BeginDisabled(!enabled);
  ImGui::PushStyleColor(ImGuiCol_Button, to_vec(ui.colors.accent));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, to_vec(ui.colors.accent_text));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, to_vec(ui.colors.accent));
  ImGui::PushStyleColor(ImGuiCol_Text, to_vec(ui.colors.on_accent));
  ImGui::PushFont(ui.fonts.bold);
  const bool pressed = ImGui::Button(label, {width, ui.px(30)});
  ImGui::PopFont();
  ImGui::PopStyleColor(4);
  ImGui::EndDisabled();
  return pressed;
}

void beside_or_below(const Ui& ui, const char* label, float gap) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const float wanted = text_size(label).x + 2 * ImGui::GetStyle().FramePadding.x;
  if (ImGui::GetItemRectMax().x + ui.px(gap) + wanted <= right) ImGui::SameLine(0, ui.px(gap));
}

bool plain_button(const Ui& ui, const char* label, bool enabled, float width, float height) {
  ImGui::BeginDisabled(!enabled);
  ImGui::PushStyleColor(ImGuiCol_Button, to_vec(ui.colors.hover));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, to_vec(ui.colors.line));
  const bool pressed = ImGui::Button(label, {width, height > 0 ? height : ui.px(30)});
  ImGui::PopStyleColor(2);
  ImGui::EndDisabled();
  return pressed;
}

bool section(const Ui& ui, const char* title, bool open_at_first) {
  ImGuiStorage* store = ImGui::GetStateStorage();
  const ImGuiID id = ImGui::GetID(title);
  bool open = store->GetBool(id, open_at_first);
  ImGui::PushID(title);
  const float height = ui.px(30);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  if (ImGui::InvisibleButton("fold", {std::max(width, 1.0f), height})) {
    open = !open;
    store->SetBool(id, open);
  }
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = at.y + (height - ui.fonts.bold->FontSize) / 2;
  draw_text(list, ui.fonts.bold, {at.x, y}, to_u32(ui.colors.text, hovered ? 1.0f : 0.92f), title);
  const char* arrow = open ? icon::down : icon::left;
  draw_text(list, ui.fonts.ui, {at.x + width - ui.px(12), y}, to_u32(ui.colors.quiet), arrow);
  ImGui::PopID();
  return open;
}

void bold_text(const Ui& ui, std::string_view s) {
  const Font bold(ui.fonts.bold);
  text(s);
}

void subtitle(const Ui& ui, const char* text) {
  ImGui::Dummy({0, ui.px(4)});
  const Font bold(ui.fonts.bold);
  wrapped_text(text);
}

void quiet_text(const Ui& ui, std::string_view s, bool wrapped) {
  const Font font(ui.fonts.small);
  ImGui::PushStyleColor(ImGuiCol_Text, to_vec(ui.colors.quiet));
  if (wrapped)
    wrapped_text(s);
  else
    text(s);
  ImGui::PopStyleColor();
}

void value_row(const Ui& ui, std::string_view label, std::string_view value, Rgb color) {
  const Row row(ui, 21);
  row.pair(ui.colors.quiet, label, color != 0 ? color : ui.colors.text, value);
  ImGui::Dummy({row.width, row.high - ImGui::GetStyle().ItemSpacing.y});
}

bool link_row(const Ui& ui, const char* id, std::string_view label, std::string_view value,
              std::string_view hint, std::size_t number) {
  Row row(ui, 23);
  ImGui::PushID(id);
  const bool pressed = row.button(number);
  ImGui::PopID();
  row.link();
  row.pair(ui.colors.accent_text, label, ui.colors.text, value);
  if (!hint.empty()) tip(ui, label, hint);
  row.below();
  return pressed;
}

void limit_bar(const Ui& ui, std::string_view label, double value, double limit, bool good,
               std::string_view unit, bool limit_is_upper) {
  const std::string_view sign = value < limit ? " < " : value > limit ? " > " : " = ";
  std::string shown = number_beside(value, limit) + std::string(sign) + trimmed(short_number(limit));
  if (!unit.empty()) shown += " " + std::string(unit);
  value_row(ui, label, shown, good ? ui.colors.good_text : ui.colors.bad_text);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, thick = ui.px(6);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low{at.x, at.y + ui.px(2)}, high{at.x + width, at.y + ui.px(2) + thick};
  const double reach = 2 * limit;
  const float part = static_cast<float>(std::clamp(reach > 0 ? value / reach : 0.0, 0.0, 1.0));
  const float mark = at.x + width * 0.5f;
  list.AddRectFilled(low, high, to_u32(ui.colors.line), thick / 2);
  // The forbidden side is tinted, so that colour is not the only sign.
  if (limit_is_upper)
    list.AddRectFilled({mark, low.y}, high, to_u32(ui.colors.bad, 0.22f), thick / 2);
  else
    list.AddRectFilled(low, {mark, high.y}, to_u32(ui.colors.bad, 0.22f), thick / 2);
  if (part > 0)
    list.AddRectFilled(low, {std::max(low.x + width * part, low.x + thick), high.y},
                       to_u32(good ? ui.colors.good : ui.colors.bad), thick / 2);
  list.AddRectFilled({mark - ui.px(1), low.y - ui.px(3)}, {mark + ui.px(1), high.y + ui.px(3)},
                     to_u32(ui.colors.text));
  ImGui::Dummy({width, thick + ui.px(4)});
  tip(ui, std::string(label),
      std::string(limit_is_upper ? "Must not exceed " : "Must not fall below ") + short_number(limit) + " " +
          std::string(unit) + ".");
}

bool toggle(const Ui& ui, const char* id, bool& on) {
  const float height = ui.px(16), width = ui.px(28);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(id);
  const bool pressed = ImGui::InvisibleButton("toggle", {width, ui.px(20)});
  ImGui::PopID();
  if (pressed) on = !on;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = at.y + ui.px(2), radius = height / 2;
  const float bright = ImGui::IsItemHovered() ? 1.0f : 0.9f;
  list.AddRectFilled({at.x, y}, {at.x + width, y + height},
                     on ? to_u32(ui.colors.accent, bright) : to_u32(ui.colors.quiet, 0.45f), radius);
  list.AddCircleFilled({on ? at.x + width - radius : at.x + radius, y + radius}, radius - ui.px(2.5f),
                       to_u32(on ? ui.colors.on_accent : ui.colors.panel), 24);
  return pressed;
}

bool segmented(const Ui& ui, const char* id, std::span<const char* const> labels, int& chosen, float width) {
  if (width <= 0) width = ImGui::GetContentRegionAvail().x;
  const float height = ui.px(26), each = width / static_cast<float>(labels.size());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ui.px(5);
  list.AddRectFilled(at, {at.x + width, at.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
  bool changed = false;
  ImGui::PushID(id);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const float x = at.x + each * static_cast<float>(i);
    ImGui::SetCursorScreenPos({x, at.y});
    ImGui::PushID(static_cast<int>(i));
    const bool pressed = ImGui::InvisibleButton("segment", {each, height});
    ImGui::PopID();
    const bool lit = chosen == static_cast<int>(i);
    if (pressed && !lit) {
      chosen = static_cast<int>(i);
      changed = true;
    }
    if (lit)
      list.AddRectFilled({x + ui.px(2), at.y + ui.px(2)}, {x + each - ui.px(2), at.y + height - ui.px(2)},
                         to_u32(ui.colors.accent, 0.24f), rounding - ui.px(1));
    const std::string shown = fitted(labels[i], each - ui.px(4));
    const ImVec2 extent = text_size(shown);
    draw_text(
        list, ImGui::GetFont(), {x + (each - extent.x) / 2, at.y + (height - extent.y) / 2},
        to_u32(lit ? ui.colors.accent_text : ui.colors.text, lit || ImGui::IsItemHovered() ? 1.0f : 0.8f),
        shown);
  }
  ImGui::PopID();
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({width, height});
  return changed;
}

void heading(Ui& ui, const char* icon, const std::string& title, const std::string& note) {
  const float buttons = 2 * ui.px(28) + ui.px(56);
  {
    const Font bold(ui.fonts.bold);
    text(fitted(std::string(icon) + "  " + title, ImGui::GetContentRegionAvail().x - buttons - ui.px(4)));
  }
  ImGui::SameLine();
  ImGui::SetCursorPos({ImGui::GetWindowContentRegionMax().x - buttons, ImGui::GetCursorPosY() - ui.px(5)});
  key_button(ui, "break-here", ui.px(48));
  ImGui::SameLine(0, ui.px(4));
  command_button(ui, "frame", isoscope::icon::target);
  ImGui::SameLine(0, ui.px(4));
  command_button(ui, "clear", isoscope::icon::close);
  if (!note.empty()) quiet_text(ui, note, true);
  ImGui::Dummy({0, ui.px(2)});
}

void verdict_glyph(const Ui& ui, bool good) {
  const float side = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 middle{at.x + side / 2, at.y + side / 2};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float r = ui.px(4.5f);
  if (good) {
    list.AddCircleFilled(middle, r, to_u32(ui.colors.good), 20);
  } else {
    const ImU32 color = to_u32(ui.colors.bad_text);
    list.AddLine({middle.x - r, middle.y - r}, {middle.x + r, middle.y + r}, color, ui.px(2));
    list.AddLine({middle.x - r, middle.y + r}, {middle.x + r, middle.y - r}, color, ui.px(2));
  }
  ImGui::Dummy({side, side});
}

void verdict_text(const Ui& ui, bool good, std::string_view s) {
  const Font small(ui.fonts.small);
  verdict_glyph(ui, good);
  ImGui::SameLine();
  wrapped_text(s);
}

} // namespace isoscope::widgets
