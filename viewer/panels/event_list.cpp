// The events with their filter.
#include "app/icons.h"
#include "app/words.h"
#include "journal/describe.h"
#include "panels/timeline_panel.h"
#include "panels/widgets.h"

#include <algorithm>
#include <cctype>

namespace isoscope {
namespace {

constexpr std::size_t scan_budget = 3000; ///< events described a frame while a text filters them

bool contains_folded(const std::string& text, const std::string& part) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

/// The sentence without the step in front, which has a column of its own.
std::string sentence(const Journal& journal, const Event& event) {
  const std::string text = describe(journal, event);
  constexpr std::string_view dot = " · ";
  const std::size_t at = text.find(dot);
  return at == std::string::npos || at > 10 ? text : text.substr(at + dot.size());
}

bool chip(const Ui& ui, const char* label, Rgb color, bool& on) {
  const ImVec2 extent = widgets::text_size(label), at = ImGui::GetCursorScreenPos();
  const ImVec2 size{extent.x + ui.px(26), ui.px(24)};
  ImGui::PushID(label);
  const bool pressed = ImGui::InvisibleButton("chip", size);
  ImGui::PopID();
  if (pressed) on = !on;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, to_u32(on ? ui.colors.hover : ui.colors.panel),
                     ui.px(12));
  list.AddRect(at, {at.x + size.x, at.y + size.y}, to_u32(ui.colors.line), ui.px(12));
  if (on)
    list.AddCircleFilled({at.x + ui.px(11), at.y + size.y / 2}, ui.px(4), to_u32(color), 16);
  else
    list.AddCircle({at.x + ui.px(11), at.y + size.y / 2}, ui.px(3.5f), to_u32(color), 16, ui.px(1.2f));
  widgets::draw_text(list, ImGui::GetFont(), {at.x + ui.px(19), at.y + (size.y - extent.y) / 2},
                     to_u32(ui.colors.text, on ? 1.0f : 0.6f), label);
  return pressed;
}

} // namespace

bool EventList::passes(const Journal& journal, const Event& event) const {
  if (!conditions_.at(static_cast<std::size_t>(event.condition))) return false;
  if (event.operation ? !operations_ : !others_) return false;
  return applied_.empty() || contains_folded(describe(journal, event), applied_);
}

void EventList::gather(const AppModel& model) {
  const Journal* journal = model.run.journal.get();
  if (journal != journal_ || applied_ != text_.data()) {
    journal_ = journal;
    applied_ = text_.data();
    scanned_ = 0;
    rows_.clear();
  }
  if (journal_ == nullptr) return;
  const std::size_t budget = applied_.empty() ? 50 * scan_budget : scan_budget;
  const std::size_t end = std::min(journal_->events().size(), scanned_ + budget);
  for (; scanned_ < end; ++scanned_)
    if (passes(*journal_, journal_->events()[scanned_]))
      rows_.push_back(static_cast<std::uint32_t>(scanned_));
}

void EventList::draw(Ui& ui) {
  AppModel& m = ui.model;
  ImGui::PushFont(ui.fonts.small);
  ImGui::SetNextItemWidth(ui.px(220));
  ImGui::InputTextWithHint("##filter", (std::string(icon::search) + "  filter by words").c_str(),
                           text_.data(), text_.size());
  bool changed = false;
  constexpr std::array<const char*, condition_count> names{"stages", "1",           "2",      "3",
                                                           "4",      "containment", "witness"};
  for (std::size_t c = 0; c < conditions_.size(); ++c) {
    ImGui::SameLine(0, ui.px(c == 0 ? 10 : 5));
    changed |= chip(ui, names[c], condition_color(ui.theme, static_cast<int>(c)), conditions_[c]);
    widgets::tip(ui, std::string(condition_title(static_cast<Condition>(c))));
  }
  ImGui::SameLine(0, ui.px(14));
  changed |= chip(ui, "operations", ui.colors.good, operations_);
  ImGui::SameLine(0, ui.px(5));
  changed |= chip(ui, "notes", ui.colors.quiet, others_);
  if (changed) journal_ = nullptr;
  gather(m);
  ImGui::SameLine(0, ui.px(14));
  widgets::quiet_text(ui, grouped(rows_.size()) + " events");

  if (ImGui::BeginChild("rows", {0, 0}) && journal_ != nullptr) {
    const float high = ui.px(22);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // The row of the play head comes into sight when it moved.
    const Step step = m.transport.step();
    const auto current = std::partition_point(rows_.begin(), rows_.end(), [&](std::uint32_t row) {
      const Event& e = journal_->events()[row];
      return e.step + (e.operation ? 1u : 0u) < step;
    });
    if (step != scrolled_to_) {
      scrolled_to_ = step;
      const float y = static_cast<float>(current - rows_.begin()) * high;
      const float scroll = ImGui::GetScrollY(), visible = ImGui::GetWindowHeight();
      if (y < scroll || y + high > scroll + visible) ImGui::SetScrollY(std::max(0.0f, y - visible / 2));
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows_.size()), high);
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        const std::uint32_t row = rows_[static_cast<std::size_t>(i)];
        const Event& event = journal_->events()[row];
        const Step target = event.step + (event.operation ? 1u : 0u);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        ImGui::PushID(i);
        if (ImGui::InvisibleButton("event", {std::max(width, 1.0f), high})) {
          ui.commands.post("seek", {std::to_string(target)});
          if (event.sample.valid()) ui.commands.post("pick", {"sample", std::to_string(event.sample.value)});
        }
        ImGui::PopID();
        const bool here = target == step && event.operation;
        if (here || ImGui::IsItemHovered())
          list.AddRectFilled(at, {at.x + width, at.y + high},
                             to_u32(here ? ui.colors.accent : ui.colors.hover, here ? 0.18f : 1.0f),
                             ui.px(4));
        const float y = at.y + (high - ui.fonts.small->FontSize) / 2;
        const std::string number = grouped(target);
        const float extent = ui.fonts.mono->CalcTextSizeA(ui.fonts.mono->FontSize, 1e9f, 0, number.c_str()).x;
        widgets::draw_text(list, ui.fonts.mono, {at.x + ui.px(64) - extent, y}, to_u32(ui.colors.quiet),
                           number);
        const ImVec2 dot{at.x + ui.px(80), at.y + high / 2};
        const ImU32 color = to_u32(condition_color(ui.theme, static_cast<int>(event.condition)));
        if (event.operation)
          list.AddCircleFilled(dot, ui.px(4), color, 16);
        else
          list.AddRect({dot.x - ui.px(3.5f), dot.y - ui.px(3.5f)}, {dot.x + ui.px(3.5f), dot.y + ui.px(3.5f)},
                       color, 0, 0, ui.px(1.2f));
        widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(94), y}, to_u32(ui.colors.text),
                           widgets::fitted(sentence(*journal_, event), width - ui.px(100)));
      }
    ImGui::PopStyleVar();
  }
  ImGui::EndChild();
  ImGui::PopFont();
}

} // namespace isoscope
