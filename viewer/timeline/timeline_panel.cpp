// Stage lanes, density per condition, kind and reason, play head.
#include "timeline/timeline_panel.h"

#include "ask/investigation.h"
#include "debug/lane_events.h"
#include "journal/describe.h"
#include "journal/vocabulary.h"
#include "model/words.h"
#include "timeline/timeline_lanes.h"
#include "timeline/tolerance_tab.h"
#include "two_runs/comparison.h"
#include "ui/bottom_tabs.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace isoscope {

void StepRange::fit(Step steps) {
  begin = 0;
  end = std::max<double>(steps, 1);
  fits = true;
}

void StepRange::zoom(double factor, double around, Step steps) {
  const double all = std::max<double>(steps, 1);
  const double width = std::clamp((end - begin) * factor, std::min(20.0, all), all);
  const double part = (around - begin) / std::max(end - begin, 1e-9);
  begin = std::clamp(around - part * width, 0.0, all - width);
  end = begin + width;
  fits = width >= all;
}

void StepRange::pan(double by, Step steps) {
  const double all = std::max<double>(steps, 1), width = end - begin;
  begin = std::clamp(begin + by, 0.0, std::max(all - width, 0.0));
  end = begin + width;
}

float TimelinePane::to_x(double step, ImVec2 low, ImVec2 size) const {
  return low.x +
         static_cast<float>((step - range_.begin) / std::max(range_.end - range_.begin, 1e-9)) * size.x;
}

void TimelinePane::tabs(Ui& ui) {
  const BottomTab tab = ui.window.settings.panes.tab;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float left = 0;
  const float y = ImGui::GetCursorScreenPos().y;
  const bool has_study = ui.window.run.scene && ui.window.run.scene->study;
  for (std::size_t i = 0; i < bottom_tabs.size(); ++i) {
    const std::string label = std::string(bottom_tabs[i].glyph) + "  " + bottom_tabs[i].title;
    const bool lit = tab == static_cast<BottomTab>(i);
    // Of use for inputs whose tolerances were studied, or that have holes, alone.
    const auto which = static_cast<BottomTab>(i);
    if (!lit && ((which == BottomTab::tolerance && !has_study) ||
                 (which == BottomTab::loops && ui.window.rim() == nullptr)))
      continue;
    const ImVec2 extent = widgets::text_size(label);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = extent.x + ui.px(20), high = ui.px(28);
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::InvisibleButton("tab", {width, high})) ui.commands.post("tab", {bottom_tabs[i].word});
    ImGui::PopID();
    const Rgb color = lit ? ui.colors.text : ui.colors.quiet;
    widgets::draw_text(list, ui.fonts.ui, {at.x + ui.px(10), at.y + (high - extent.y) / 2},
                       to_u32(ImGui::IsItemHovered() ? ui.colors.text : color), label);
    if (lit)
      list.AddRectFilled({at.x + ui.px(8), at.y + high - ui.px(2)}, {at.x + width - ui.px(8), at.y + high},
                         to_u32(ui.colors.accent), ui.px(1));
    ImGui::SameLine(0, 0);
    left = at.x + width + ui.px(20);
  }
  ImGui::NewLine();
  left += range_chip(ui, left, y);
  // What the colours mean, where no lanes say it.
  if (tab != BottomTab::plots && tab != BottomTab::events) return breadcrumb_line(ui, left, y);
  if (tab == BottomTab::plots) return axis_switch(ui, left, y);
  const JournalIndex& index = ui.window.index;
  const auto& range = ui.window.range;
  const Step begin = range ? std::min(range->begin, index.steps()) : 0;
  const auto counts =
      index.counts(begin, range ? std::clamp(range->end + 1, begin, index.steps()) : index.steps());
  float x = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;

  for (int c = condition_count - 1; c > 0; --c) {
    const auto n = counts[static_cast<std::size_t>(c)];
    if (n == 0) continue;
    const std::string label = std::string(words(static_cast<Condition>(c)).title) + "  " + grouped(n);
    const float width = widgets::width_of(ui.fonts.small, label);
    x -= width;
    if (x - ui.px(14) < left) break;
    widgets::draw_text(list, ui.fonts.small, {x, y + (ui.px(28) - ui.fonts.small->FontSize) / 2},
                       to_u32(ui.colors.quiet), label);
    x -= ui.px(14);
    list.AddRectFilled({x, y + ui.px(10)}, {x + ui.px(8), y + ui.px(18)},
                       to_u32(condition_color(ui.theme, c)), ui.px(2));
    x -= ui.px(16);
  }
}

bool TimelinePane::scrub(Ui& ui, const char* id, ImVec2 low, ImVec2 size) {
  WindowState& m = ui.window;
  const Step live = m.live_step();
  ImGui::SetCursorScreenPos(low);
  ImGui::InvisibleButton(id, {std::max(size.x, 1.0f), std::max(size.y, 1.0f)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const ImGuiIO& io = ImGui::GetIO();
  const double step = from_part(static_cast<double>((io.MousePos.x - low.x) / size.x));
  if (ImGui::IsItemHovered() && io.MouseWheel != 0)
    range_.zoom(std::pow(0.8, static_cast<double>(io.MouseWheel)), step, live);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(1)) range_.fit(live);
  if (!ImGui::IsItemActive()) return false;
  if (ImGui::IsMouseDown(1)) {
    range_.pan(-static_cast<double>(io.MouseDelta.x / size.x) * (range_.end - range_.begin), live);
    return false;
  }
  if (choose_range(ui, step)) return false;
  // Dragging past the end takes hold of the live end again.
  if (step >= static_cast<double>(live) && range_.fits)
    m.transport.follow();
  else
    m.transport.jump(static_cast<Step>(std::clamp(std::round(step), 0.0, static_cast<double>(live))));
  return true;
}

void TimelinePane::playhead(const Ui& ui, ImVec2 low, ImVec2 size) const {
  const WindowState& m = ui.window;
  const float x = std::round(to_x(m.transport.step(), low, size));
  if (x < low.x - 1 || x > low.x + size.x + 1) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 color = to_u32(ui.colors.selection);
  list.AddLine({x, low.y}, {x, low.y + size.y}, color, ui.px(1.5f));
  const float r = ui.px(5);
  list.AddTriangleFilled({x - r, low.y}, {x + r, low.y}, {x, low.y + r * 1.4f}, color);
}

void TimelinePane::stage_lane(const Ui& ui, ImVec2 low, ImVec2 size) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const JournalIndex::StageSpan& span : ui.window.index.stages()) {
    const float x0 = to_x(span.begin, low, size), x1 = std::max(to_x(span.end, low, size), x0 + ui.px(3));
    list.AddRectFilled({x0, low.y}, {x1 - 1, low.y + size.y},
                       to_u32(stage_color(ui.theme, span.stage), span.open ? 0.55f : 0.34f), ui.px(4));
    const float y = low.y + (size.y - ui.fonts.small->FontSize) / 2;
    const std::string_view title = words(span.stage).title;
    const float extent = widgets::width_of(ui.fonts.small, title);
    const float from = std::max(x0, low.x) + ui.px(6);
    if (x1 - from > extent + ui.px(4))
      widgets::draw_text(list, ui.fonts.small, {from, y}, to_u32(ui.colors.text, 0.95f), title);
  }
}

// A lane a reason: bars a few pixels wide, as high as the lane's share of the steps below them; for
// rejections by the logarithm of their number.
void TimelinePane::density(Ui& ui, ImVec2 low, ImVec2 size, float gutter) {
  const float gap = ui.px(1), least = ui.px(12);
  const auto rows = static_cast<std::size_t>(std::max(1.0f, (size.y + gap) / (least + gap)));
  const LanesInRoom in_room = timeline_lanes(debugger_, ui.theme, rows);
  const std::vector<TimelineLane>& lanes = in_room.shown;
  const bool some_left_out = !in_room.left_out.empty();
  give_room(ui, lanes.size() + in_room.left_out.size(), some_left_out, size.y);
  if (some_left_out)
    left_out_sign(ui, in_room.left_out, {low.x - gutter, low.y + size.y - least}, {gutter - ui.px(8), least});
  if (lanes.empty()) return;
  const std::string chosen = shown_lane(debugger_);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto used = static_cast<float>(lanes.size());
  const float room = size.y - (some_left_out ? least + gap : 0);
  const float lane = std::min((room - gap * (used - 1)) / used, ui.px(30));
  float y = low.y;
  for (const TimelineLane& row : lanes) {
    const float text_y = y + (lane - ui.fonts.small->FontSize) / 2;
    lane_places_.push_back({row.name, y, y + lane});
    // Its name chooses what the event list shows; the others step back.
    ImGui::SetCursorScreenPos({low.x - gutter, y});
    ImGui::PushID(row.name.c_str());
    if (ImGui::InvisibleButton("lane", {gutter - ui.px(8), lane})) ui.commands.post("lane", {row.name});
    ImGui::PopID();
    const bool lit = row.name == chosen;
    const float strength = chosen.empty() || lit ? 1.0f : 0.35f;
    if (lit || ImGui::IsItemHovered())
      list.AddRectFilled({low.x - gutter - ui.px(3), y}, {low.x - ui.px(6), y + lane},
                         lit ? to_u32(ui.colors.accent, 0.24f) : to_u32(ui.colors.hover), ui.px(4));
    widgets::tip(ui, row.title,
                 std::string(row.help) + " A click lists these events alone, again all of them; a click on "
                                         "a bar goes to the nearest one.");
    const std::string count = grouped(row.total);
    const float extent = widgets::width_of(ui.fonts.mono, count);
    if (row.letter.empty())
      widgets::glyph(ui, {low.x - gutter + ui.px(5), y + lane / 2}, 4.5f, row.color, row.shape);
    else
      widgets::draw_text(list, ui.fonts.bold, {low.x - gutter, y + (lane - ui.fonts.bold->FontSize) / 2},
                         to_u32(row.color), row.letter);
    widgets::draw_text(list, ui.fonts.small, {low.x - gutter + ui.px(15), text_y},
                       to_u32(ui.colors.text, 0.85f * strength),
                       widgets::fitted(row.title, gutter - extent - ui.px(32)));
    widgets::draw_text(list, ui.fonts.mono, {low.x - extent - ui.px(10), text_y}, to_u32(ui.colors.quiet),
                       count);
    list.AddRectFilled({low.x, y}, {low.x + size.x, y + lane}, to_u32(ui.colors.ground, 0.6f), ui.px(3));
    lane_bars(ui, row, {low.x, y}, {size.x, lane}, strength);
    y += lane + gap;
  }
}

void TimelinePane::give_room(Ui& ui, std::size_t lanes, bool some_left_out, float high) {
  bool& asked = ui.window.requests.all_lanes;
  if (!asked) return;
  asked = false;
  constexpr float comfortable = 15; // units of the interface, a lane
  PaneLayout& panes = ui.window.settings.panes;
  const float around = ImGui::GetWindowHeight() - high;
  const float wanted = (around + static_cast<float>(lanes) * ui.px(comfortable)) / ui.scale;
  panes.bottom = some_left_out && wanted > panes.bottom + 1 ? wanted : PaneLayout().bottom;
}

void TimelinePane::left_out_sign(Ui& ui, const std::vector<TimelineLane>& left_out, ImVec2 at, ImVec2 size) {
  ImGui::SetCursorScreenPos(at);
  if (ImGui::InvisibleButton("left-out", size)) ui.commands.post("all-lanes");
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  std::string names;
  for (const TimelineLane& lane : left_out) names += lane.title + ": " + grouped(lane.total) + "\n";
  widgets::tip(ui, "Lanes without room", names + "A click enlarges the pane.");
  const widgets::Font font(ui.fonts.small);
  widgets::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small,
                     {at.x + ui.px(15), at.y + (size.y - ui.fonts.small->FontSize) / 2},
                     to_u32(ui.colors.accent_text),
                     widgets::fitted(left_out_words(left_out), size.x - ui.px(15)));
}

void TimelinePane::lane_bars(const Ui& ui, const TimelineLane& row, ImVec2 low, ImVec2 size,
                             float strength) const {
  const WindowState& m = ui.window;
  const double steps = range_.end - range_.begin;
  const int bins =
      std::max(1, static_cast<int>(std::min(static_cast<double>(size.x / ui.px(3)), std::ceil(steps))));
  const auto edge = [&](int i) { return static_cast<Step>(range_.begin + steps * i / bins); };
  // By bin and part.
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(bins) * row.parts.size(), 0);
  const auto of_bin = [&](int i) {
    return std::span(numbers).subspan(static_cast<std::size_t>(i) * row.parts.size(), row.parts.size());
  };
  std::uint32_t largest = 1;
  for (int i = 0; i < bins; ++i) {
    // The last bin also holds what was rejected after the last operation.
    const Step begin = edge(i), end = std::max(edge(i + 1), begin + 1) + (i + 1 == bins ? 1 : 0);
    const auto of_parts = of_bin(i);
    std::uint32_t n = 0;
    for (std::size_t p = 0; p < row.parts.size(); ++p)
      n += of_parts[p] = row.parts[p].count(begin, row.rejections ? end : std::min(end, m.index.steps()));
    largest = std::max(largest, n);
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < bins; ++i) {
    const auto of_parts = of_bin(i);
    const auto n = static_cast<float>(std::accumulate(of_parts.begin(), of_parts.end(), 0u));
    if (n == 0) continue;
    const Step begin = edge(i);
    const auto width = static_cast<float>(std::max(edge(i + 1), begin + 1) - begin);
    const float share = row.rejections ? std::log1p(n) / std::log1p(static_cast<float>(largest))
                                       : std::sqrt(std::min(n / width, 1.0f));
    const float x0 = low.x + size.x * static_cast<float>(i) / static_cast<float>(bins),
                x1 = low.x + size.x * static_cast<float>(i + 1) / static_cast<float>(bins);
    float y = low.y + size.y;
    for (std::size_t p = 0; p < row.parts.size(); ++p) {
      if (of_parts[p] == 0) continue;
      const float part = share * static_cast<float>(of_parts[p]) / n;
      const float high = std::max(ui.px(2), (size.y - ui.px(1)) * part);
      list.AddRectFilled({x0, y - high}, {std::max(x1, x0 + 1), y},
                         to_u32(row.parts[p].color, strength * (begin < m.transport.step() ? 0.9f : 0.38f)));
      y -= high;
    }
  }
}

void TimelinePane::lane_click(Ui& ui, ImVec2 low, ImVec2 size) {
  constexpr float reach = 5; // units of the interface
  if (!ImGui::IsItemDeactivated() || !ImGui::IsMouseReleased(0)) return;
  const ImVec2 moved = ImGui::GetMouseDragDelta(0, 0), mouse = ImGui::GetIO().MousePos;
  if (std::hypot(moved.x, moved.y) > ui.px(3)) return;
  const double steps = range_.end - range_.begin, pixel = steps / static_cast<double>(size.x);
  const double at = range_.begin + static_cast<double>(mouse.x - low.x) * pixel;
  const auto step = static_cast<Step>(std::max(at, 0.0));
  const auto near = static_cast<Step>(std::ceil(static_cast<double>(ui.px(reach)) * pixel));
  for (const LanePlace& lane : lane_places_)
    if (mouse.y >= lane.low && mouse.y < lane.high && nearest_event(debugger_, lane.name, step, near))
      ui.commands.post("lane-event", {lane.name, std::to_string(step)});
}

void TimelinePane::marks(const Ui& ui, ImVec2 low, ImVec2 size, float y) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const JournalIndex::Mark& mark : ui.window.index.marks()) {
    const float x = to_x(mark.step, low, size);
    if (x < low.x || x > low.x + size.x) continue;
    const Rgb color = mark.kind == EventKind::warning || mark.kind == EventKind::stopped ? ui.colors.warning
                      : mark.kind == EventKind::topology_check                           ? ui.colors.gamma
                                                                                         : ui.colors.text;
    list.AddCircleFilled({x, y}, ui.px(3), to_u32(color), 12);
  }
  const auto& bookmarks = talk_.bookmarks.all();
  for (std::size_t i = 0; i < bookmarks.size(); ++i) {
    const float x = to_x(bookmarks[i].step, low, size), r = ui.px(4);
    if (x < low.x || x > low.x + size.x) continue;
    const bool current = talk_.bookmarks.current() == i;
    const std::string number = std::to_string(i + 1);
    const float extent = widgets::width_of(ui.fonts.small, number);
    const bool fits = x + ui.px(4) + extent < low.x + size.x;
    list.AddLine({x, low.y}, {x, y}, to_u32(ui.colors.accent, current ? 0.9f : 0.45f));
    list.AddTriangleFilled({x - r, y + r}, {x + r, y + r}, {x, y - r}, to_u32(ui.colors.accent));
    widgets::draw_text(list, ui.fonts.small, {fits ? x + ui.px(4) : x - ui.px(4) - extent, y - ui.px(14)},
                       to_u32(ui.colors.text), number);
  }
}

void TimelinePane::ruler(const Ui& ui, ImVec2 low, ImVec2 size) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double span = range_.end - range_.begin,
               wanted = span / std::max(1.0, static_cast<double>(size.x / ui.px(110)));
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(wanted, 1.0))));
  const double part = wanted / decade;
  const double tick = std::max(1.0, (part > 5 ? 10 : part > 2 ? 5 : part > 1 ? 2 : 1) * decade);
  for (double s = std::ceil(range_.begin / tick) * tick; s <= range_.end; s += tick) {
    const float x = to_x(s, low, size);
    list.AddLine({x, low.y}, {x, low.y + ui.px(4)}, to_u32(ui.colors.quiet, 0.7f));
    const std::string label = grouped(static_cast<std::size_t>(s));
    const float width = widgets::width_of(ui.fonts.small, label);
    if (x + ui.px(4) + width < low.x + size.x)
      widgets::draw_text(list, ui.fonts.small, {x + ui.px(4), low.y + ui.px(1)}, to_u32(ui.colors.quiet),
                         label);
  }
}

void TimelinePane::timeline(Ui& ui) {
  const WindowState& m = ui.window;
  const JournalIndex& index = m.index;
  const ImVec2 origin = ImGui::GetCursorScreenPos(), all = ImGui::GetContentRegionAvail();
  const float gutter = ui.px(176);
  if (all.x < gutter + ui.px(60) || all.y < ui.px(50)) return;
  const float ruler_high = ui.px(18), stage_high = ui.px(18);
  const ImVec2 low{origin.x + gutter, origin.y}, size{all.x - gutter - ui.px(4), all.y};
  const float top = low.y + stage_high + ui.px(4), bottom = low.y + size.y - ruler_high;
  lane_places_.clear();
  if (index.steps() > 0) density(ui, {low.x, top}, {size.x, bottom - top - ui.px(6)}, gutter);
  scrub(ui, "timeline", low, size);
  const bool hovered = ImGui::IsItemHovered();
  lane_click(ui, low, size);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (index.steps() == 0) {
    widgets::draw_text(list, ui.fonts.small, {low.x, (top + bottom) / 2}, to_u32(ui.colors.quiet),
                       "Operations appear here as the run makes them. Drag to scrub, wheel to zoom.");
    return;
  }
  widgets::draw_text(list, ui.fonts.small, {origin.x, low.y + ui.px(2)}, to_u32(ui.colors.quiet), "stage");
  list.PushClipRect({low.x - ui.px(6), low.y}, {low.x + size.x + ui.px(6), low.y + size.y}, true);
  stage_lane(ui, low, {size.x, stage_high});
  forecast_band(ui, low, {size.x, bottom - low.y});
  marks(ui, low, size, bottom - ui.px(1));
  ruler(ui, {low.x, bottom}, {size.x, ruler_high});
  const float live_x = to_x(m.live_step(), low, size);
  if (m.running())
    list.AddRectFilled({live_x - ui.px(2), low.y}, {live_x, bottom}, to_u32(ui.colors.good_text));
  shade_range(ui, {low.x, low.y}, {size.x, bottom - low.y});
  playhead(ui, low, {size.x, bottom - low.y});
  list.PopClipRect();
  if (!hovered || ImGui::IsAnyMouseDown()) return;
  const double at = range_.begin + static_cast<double>((ImGui::GetIO().MousePos.x - low.x) / size.x) *
                                       (range_.end - range_.begin);
  const auto step = static_cast<Step>(std::clamp(at, 0.0, static_cast<double>(index.steps() - 1)));
  const Journal& journal = *index.journal();
  std::string text = describe(journal, journal.events()[journal.operations()[step].event]);
  const double column = (range_.end - range_.begin) * static_cast<double>(ui.px(3) / size.x);
  const Step reach = std::max<Step>(1, static_cast<Step>(column));
  std::string stayed;
  for (const Reason reason : rejecting_reasons) {
    const auto n = index.rejections(reason, step, step + reach);
    if (n > 0)
      stayed += (stayed.empty() ? "\nEdges that stayed here: " : ", ") + grouped(n) + " " +
                std::string(words(reason).title);
  }
  widgets::tip(ui, "Step " + grouped(step + 1), text + stayed);
}

void TimelinePane::draw(Ui& ui) {
  if (range_.fits) range_.fit(ui.window.live_step());
  tabs(ui);
  switch (ui.window.settings.panes.tab) {
  case BottomTab::plots: {
    // A chosen range is what the plots show.
    const StepRange shown = range_;
    const auto& chosen = ui.window.range;
    if (chosen)
      range_ = {static_cast<double>(chosen->begin), std::max(chosen->end, chosen->begin + 1) * 1.0, false};
    plots(ui);
    if (chosen) range_ = shown;
    break;
  }
  case BottomTab::events:
    events_.draw(ui, debugger_);
    break;
  case BottomTab::breakpoints:
    breakpoints_.draw(ui, debugger_);
    break;
  case BottomTab::history:
    panels::history_tab(ui, asked_);
    break;
  case BottomTab::work:
    panels::work_tab(ui, asked_);
    break;
  case BottomTab::compare:
    panels::compare_tab(ui, comparison_);
    break;
  case BottomTab::loops:
    panels::loops_tab(ui, asked_);
    break;
  case BottomTab::tolerance:
    panels::tolerance_tab(ui);
    break;
  case BottomTab::timeline:
    timeline(ui);
    break;
  }
}

} // namespace isoscope
