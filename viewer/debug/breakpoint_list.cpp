// A field for another one, and a line each.
#include "debug/event_list.h"

#include "debug/debugger.h"
#include "model/words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>

namespace isoscope {

Rgb lane_color(std::size_t filter) {
  // Okabe and Ito's set, apart for every kind of sight; the letter tells lanes that are as many apart.
  constexpr std::array<Rgb, 8> colors{0xE69F00, 0x56B4E9, 0x009E73, 0xCC79A7,
                                      0xD55E00, 0x0072B2, 0xB9AC2F, 0x9B7BD8};
  return colors.at(filter % colors.size());
}

std::string lane_letter(std::size_t filter) {
  return std::string(1, static_cast<char>('A' + static_cast<char>(filter % 26)));
}

void query_error(Ui& ui, const QueryError& error, const std::string& text, float left) {
  const std::string before = text.substr(0, std::min(error.place, text.size()));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  // The caret stands below the field where the text is wrong, unless that is beyond the field.
  const float x =
      left + ImGui::GetStyle().FramePadding.x + std::min(widgets::text_size(before).x, ui.px(280));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float r = ui.px(4);
  list.AddTriangleFilled({x, at.y - ui.px(3)}, {x - r, at.y + r}, {x + r, at.y + r},
                         to_u32(ui.colors.bad_text));
  widgets::draw_text(list, ui.fonts.small, {left + ui.px(4), at.y + ui.px(6)}, to_u32(ui.colors.bad_text),
                     error.message + (error.remedy.empty() ? "" : "  " + error.remedy));
  ImGui::Dummy({1, ui.px(24)});
}

void BreakpointList::draw(Ui& ui, const Debugger& debugger) {
  const widgets::Font font(ui.fonts.small);
  const float left = ImGui::GetCursorScreenPos().x;
  ImGui::SetNextItemWidth(ui.px(300));
  const bool entered =
      ImGui::InputTextWithHint("##condition", "reject && reason == kernel_empty, genus != expected …",
                               text_.data(), text_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  const std::string text = text_.data();
  const ParsedQuery parsed = parse_query(text);
  const auto* error = std::get_if<QueryError>(&parsed);
  ImGui::SameLine(0, ui.px(8));
  const bool valid = !text.empty() && error == nullptr;
  if ((widgets::plain_button(ui, "add", valid, 0, ui.px(24)) || entered) && valid) {
    ui.commands.post("break", {text});
    text_[0] = 0;
  }
  ImGui::SameLine(0, ui.px(8));
  const auto suggested = suggested_breaks(debugger);
  if (widgets::plain_button(ui, "break on the selection", !suggested.empty(), 0, ui.px(24)))
    ui.commands.post("break-here");
  widgets::tip(ui, "Break on the selection   F9", suggested.empty() ? "" : suggested.front().condition);
  ImGui::SameLine(0, ui.px(20));
  widgets::command_button(ui, "reverse-continue", icon::left);
  ImGui::SameLine(0, ui.px(2));
  widgets::command_button(ui, "continue");
  if (error != nullptr) query_error(ui, *error, text, left);

  const auto list = debugger.breakpoints->list();
  if (list.empty()) {
    widgets::quiet_text(
        ui,
        "A breakpoint pauses the run at every event for which its condition holds. F9 makes one "
        "of what is selected, F5 goes on to the next, Shift+F5 back to the one before.",
        true);
  } else if (ImGui::BeginChild("breakpoints", {0, 0})) {
    for (const BreakpointState& b : list) {
      ImGui::PushID(static_cast<int>(b.id));
      const std::string id = std::to_string(b.id);
      bool on = b.enabled;
      if (widgets::toggle(ui, "on", on)) ui.commands.post("breakpoint", {id, on ? "on" : "off"});
      ImGui::SameLine(0, ui.px(10));
      const widgets::Row row(ui, 22);
      row.text(ui.fonts.mono, 0, ui.colors.quiet, id);
      row.fitted(ui.fonts.mono, 28, b.enabled ? ui.colors.text : ui.colors.quiet, b.text,
                 row.width - ui.px(280));
      std::string count = counted(b.hits, "hit");
      if (b.ignore > 0) count += ", first " + grouped(b.ignore) + " ignored";
      if (b.last_event) count += ", last at event " + grouped(*b.last_event);
      row.text(ui.fonts.small, row.width / ui.scale - 230, ui.colors.quiet, count);
      ImGui::Dummy({std::max(row.width - ui.px(34), 1.0f), row.high});
      ImGui::SameLine(0, ui.px(4));
      if (widgets::icon_button(ui, "remove", icon::close)) ui.commands.post("breakpoint", {id, "remove"});
      ImGui::PopID();
    }
    ImGui::EndChild();
  } else {
    ImGui::EndChild();
  }
}

} // namespace isoscope
