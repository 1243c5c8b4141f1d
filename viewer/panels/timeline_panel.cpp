// Density per condition, stage lanes, play head; four figures over the steps.
#include "panels/timeline_panel.h"

#include "app/icons.h"
#include "app/words.h"
#include "journal/describe.h"
#include "panels/widgets.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
  constexpr std::array<const char*, 3> names{"Timeline", "Plots", "Events"};
  constexpr std::array<const char*, 3> glyphs{icon::clock, icon::chart, icon::list};
  constexpr std::array<const char*, 3> words{"timeline", "plots", "events"};
  const int tab = ui.model.settings.panes.tab;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float left = 0;
  const float y = ImGui::GetCursorScreenPos().y;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string label = std::string(glyphs[i]) + "  " + names[i];
    const bool lit = tab == static_cast<int>(i);
    const ImVec2 extent = widgets::text_size(label);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = extent.x + ui.px(20), high = ui.px(28);
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::InvisibleButton("tab", {width, high})) ui.commands.post("tab", {words[i]});
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
  // What the colours mean, where no lanes say it.
  ImGui::NewLine();
  if (tab == 0) return;
  const JournalIndex& index = ui.model.index;
  const auto counts = index.counts(0, index.steps());
  float x = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;

  for (int c = condition_count - 1; c >= 0; --c) {
    const auto n = counts[static_cast<std::size_t>(c)];
    if (n == 0) continue;
    const std::string label = std::string(condition_title(static_cast<Condition>(c))) + "  " + grouped(n);
    const float width = ui.fonts.small->CalcTextSizeA(ui.fonts.small->FontSize, 1e9f, 0, label.c_str()).x;
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
  AppModel& m = ui.model;
  const Step live = m.live_step();
  ImGui::SetCursorScreenPos(low);
  ImGui::InvisibleButton(id, {std::max(size.x, 1.0f), std::max(size.y, 1.0f)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const ImGuiIO& io = ImGui::GetIO();
  const double step =
      range_.begin + static_cast<double>((io.MousePos.x - low.x) / size.x) * (range_.end - range_.begin);
  if (ImGui::IsItemHovered() && io.MouseWheel != 0)
    range_.zoom(std::pow(0.8, static_cast<double>(io.MouseWheel)), step, live);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(1)) range_.fit(live);
  if (!ImGui::IsItemActive()) return false;
  if (ImGui::IsMouseDown(1)) {
    range_.pan(-static_cast<double>(io.MouseDelta.x / size.x) * (range_.end - range_.begin), live);
    return false;
  }
  // Dragging past the end takes hold of the live end again.
  if (step >= static_cast<double>(live) && range_.fits)
    m.transport.follow();
  else
    m.transport.jump(static_cast<Step>(std::clamp(std::round(step), 0.0, static_cast<double>(live))));
  return true;
}

void TimelinePane::playhead(const Ui& ui, ImVec2 low, ImVec2 size) const {
  const AppModel& m = ui.model;
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
  for (const JournalIndex::StageSpan& span : ui.model.index.stages()) {
    const float x0 = to_x(span.begin, low, size), x1 = std::max(to_x(span.end, low, size), x0 + ui.px(3));
    list.AddRectFilled({x0, low.y}, {x1 - 1, low.y + size.y},
                       to_u32(ui.colors.accent, span.open ? 0.30f : 0.16f), ui.px(4));
    const float y = low.y + (size.y - ui.fonts.small->FontSize) / 2;
    if (x1 - x0 > ui.px(50))
      widgets::draw_text(list, ui.fonts.small, {std::max(x0, low.x) + ui.px(8), y},
                         to_u32(ui.colors.text, 0.9f), stage_title(span.stage));
  }
}

// A lane a condition: bars a few pixels wide, as high as the condition's share of the steps below them.
void TimelinePane::density(const Ui& ui, ImVec2 low, ImVec2 size, float gutter) const {
  const AppModel& m = ui.model;
  const auto totals = m.index.counts(0, m.index.steps());
  const auto used =
      static_cast<int>(std::count_if(totals.begin(), totals.end(), [](auto n) { return n > 0; }));
  if (used == 0) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float gap = ui.px(3),
              lane = std::min((size.y - gap * static_cast<float>(used - 1)) / static_cast<float>(used),
                              ui.px(40));
  const double steps = range_.end - range_.begin;
  const int bins =
      std::max(1, static_cast<int>(std::min(static_cast<double>(size.x / ui.px(3)), std::ceil(steps))));
  float y = low.y;
  for (std::size_t c = 0; c < totals.size(); ++c) {
    if (totals[c] == 0) continue;
    const Rgb color = condition_color(ui.theme, static_cast<int>(c));
    const float text_y = y + (lane - ui.fonts.small->FontSize) / 2;
    const std::string count = grouped(totals[c]);
    const float extent = ui.fonts.mono->CalcTextSizeA(ui.fonts.mono->FontSize, 1e9f, 0, count.c_str()).x;
    list.AddRectFilled({low.x - gutter, y + lane / 2 - ui.px(4)},
                       {low.x - gutter + ui.px(8), y + lane / 2 + ui.px(4)}, to_u32(color), ui.px(2));
    widgets::draw_text(list, ui.fonts.small, {low.x - gutter + ui.px(14), text_y},
                       to_u32(ui.colors.text, 0.85f), condition_title(static_cast<Condition>(c)));
    widgets::draw_text(list, ui.fonts.mono, {low.x - extent - ui.px(10), text_y}, to_u32(ui.colors.quiet),
                       count);
    list.AddRectFilled({low.x, y}, {low.x + size.x, y + lane}, to_u32(ui.colors.ground, 0.6f), ui.px(4));
    for (int i = 0; i < bins; ++i) {
      const auto begin = static_cast<Step>(range_.begin + steps * i / bins),
                 end = static_cast<Step>(range_.begin + steps * (i + 1) / bins);
      const Step last = std::min(std::max(end, begin + 1), m.index.steps());
      if (last <= begin) break;
      const auto n = m.index.counts(begin, last)[c];
      if (n == 0) continue;
      const float share = static_cast<float>(n) / static_cast<float>(last - begin);
      const float x0 = low.x + size.x * static_cast<float>(i) / static_cast<float>(bins),
                  x1 = low.x + size.x * static_cast<float>(i + 1) / static_cast<float>(bins);
      const float high = std::max(ui.px(3), (lane - ui.px(2)) * std::sqrt(share));
      list.AddRectFilled({x0, y + lane - high}, {std::max(x1, x0 + 1), y + lane},
                         to_u32(color, begin < m.transport.step() ? 0.9f : 0.38f));
    }
    y += lane + gap;
  }
}

void TimelinePane::marks(const Ui& ui, ImVec2 low, ImVec2 size, float y) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const JournalIndex::Mark& mark : ui.model.index.marks()) {
    const float x = to_x(mark.step, low, size);
    if (x < low.x || x > low.x + size.x) continue;
    const Rgb color = mark.kind == EventKind::warning || mark.kind == EventKind::stopped ? ui.colors.warning
                      : mark.kind == EventKind::topology_check                           ? ui.colors.gamma
                                                                                         : ui.colors.text;
    list.AddCircleFilled({x, y}, ui.px(3), to_u32(color), 12);
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
    const float width = ui.fonts.small->CalcTextSizeA(ui.fonts.small->FontSize, 1e9f, 0, label.c_str()).x;
    if (x + ui.px(4) + width < low.x + size.x)
      widgets::draw_text(list, ui.fonts.small, {x + ui.px(4), low.y + ui.px(1)}, to_u32(ui.colors.quiet),
                         label);
  }
}

void TimelinePane::timeline(Ui& ui) {
  const AppModel& m = ui.model;
  const JournalIndex& index = m.index;
  const ImVec2 origin = ImGui::GetCursorScreenPos(), all = ImGui::GetContentRegionAvail();
  const float gutter = ui.px(176);
  if (all.x < gutter + ui.px(60) || all.y < ui.px(50)) return;
  const float ruler_high = ui.px(18), stage_high = ui.px(18);
  const ImVec2 low{origin.x + gutter, origin.y}, size{all.x - gutter - ui.px(4), all.y};
  scrub(ui, "timeline", low, size);
  const bool hovered = ImGui::IsItemHovered();
  const float top = low.y + stage_high + ui.px(4), bottom = low.y + size.y - ruler_high;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (index.steps() == 0) {
    widgets::draw_text(list, ui.fonts.small, {low.x, (top + bottom) / 2}, to_u32(ui.colors.quiet),
                       "Operations appear here as the run makes them. Drag to scrub, wheel to zoom.");
    return;
  }
  widgets::draw_text(list, ui.fonts.small, {origin.x, low.y + ui.px(2)}, to_u32(ui.colors.quiet), "stage");
  density(ui, {low.x, top}, {size.x, bottom - top - ui.px(6)}, gutter);
  list.PushClipRect({low.x - ui.px(6), low.y}, {low.x + size.x + ui.px(6), low.y + size.y}, true);
  stage_lane(ui, low, {size.x, stage_high});
  marks(ui, low, size, bottom - ui.px(1));
  ruler(ui, {low.x, bottom}, {size.x, ruler_high});
  const float live_x = to_x(m.live_step(), low, size);
  if (m.running())
    list.AddRectFilled({live_x - ui.px(2), low.y}, {live_x, bottom}, to_u32(ui.colors.good_text));
  playhead(ui, low, {size.x, bottom - low.y});
  list.PopClipRect();
  if (!hovered || ImGui::IsAnyMouseDown()) return;
  const double at = range_.begin + static_cast<double>((ImGui::GetIO().MousePos.x - low.x) / size.x) *
                                       (range_.end - range_.begin);
  const auto step = static_cast<Step>(std::clamp(at, 0.0, static_cast<double>(index.steps() - 1)));
  const Journal& journal = *index.journal();
  widgets::tip(ui, "Step " + grouped(step + 1),
               describe(journal, journal.events()[journal.operations()[step].event]));
}

void TimelinePane::plots(Ui& ui) {
  AppModel& m = ui.model;
  struct Plot {
    const char* name;
    Figure figure;
    Rgb color;
    bool logarithmic;
    const char* unit;
  };
  const std::array<Plot, 4> all{
      {{"bad samples", Figure::bad_samples, ui.colors.bad_text, true, ""},
       {"largest ε", Figure::largest_error, ui.colors.warning_text, true, ""},
       {"vertices of Z", Figure::zero_set_vertices, ui.colors.text, false, ""},
       {"smallest height", Figure::smallest_height, ui.colors.accent_text, true, " δ"}}};
  const ImVec2 origin = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float gap = ui.px(10), width = (room.x - 3 * gap) / 4;
  if (width < ui.px(60) || room.y < ui.px(40)) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Plot& plot = all[i];
    const ImVec2 low{origin.x + static_cast<float>(i) * (width + gap), origin.y}, size{width, room.y};
    ImGui::PushID(plot.name);
    scrub(ui, "plot", low, size);
    ImGui::PopID();
    const ImVec2 high{low.x + size.x, low.y + size.y};
    list.AddRectFilled(low, high, to_u32(ui.colors.ground, 0.6f), ui.px(5));
    list.PushClipRect(low, high, true);
    const std::vector<float>& values = m.index.values(plot.figure);
    const float top = low.y + ui.px(24), bottom = high.y - ui.px(6);
    const auto first = static_cast<std::size_t>(range_.begin);
    const std::size_t last = std::min(values.size(), static_cast<std::size_t>(range_.end) + 1);
    float smallest = std::numeric_limits<float>::infinity(), largest = -smallest;
    const auto shown = [&](float v) { return plot.logarithmic ? std::log10(std::max(v, 1e-3f)) : v; };
    for (std::size_t k = first; k < last; ++k)
      if (std::isfinite(values[k])) {
        smallest = std::min(smallest, shown(values[k]));
        largest = std::max(largest, shown(values[k]));
      }
    if (last > first && largest >= smallest) {
      const float reach = std::max(largest - smallest, 1e-6f);
      const auto y_of = [&](float v) { return bottom - (shown(v) - smallest) / reach * (bottom - top); };
      // Two values a pixel pair where steps are dense, each step once where they are not.
      const double columns = std::min(static_cast<double>(size.x / 2), range_.end - range_.begin);
      const double stride = std::max(1.0, (range_.end - range_.begin) / std::max(columns, 1.0));
      std::vector<ImVec2> line;
      for (double from = static_cast<double>(first); from < static_cast<double>(last); from += stride) {
        const auto k0 = static_cast<std::size_t>(from);
        const std::size_t k1 = std::min(last, static_cast<std::size_t>(from + stride));
        for (std::size_t k = k0; k < std::max(k1, k0 + 1); k += std::max<std::size_t>(1, (k1 - k0) / 2))
          if (std::isfinite(values[k]))
            line.push_back({to_x(static_cast<double>(k + 1), low, size), y_of(values[k])});
      }
      list.AddPolyline(line.data(), static_cast<int>(line.size()), to_u32(plot.color), 0, ui.px(1.6f));
    }
    playhead(ui, {low.x, low.y + ui.px(20)}, {size.x, size.y - ui.px(20)});
    widgets::draw_text(list, ui.fonts.small, {low.x + ui.px(10), low.y + ui.px(5)}, to_u32(ui.colors.quiet),
                       plot.name);
    const Step step = m.transport.step();
    if (step > 0 && step <= values.size()) {
      const auto number = static_cast<double>(values[step - 1]);
      const bool whole = plot.figure == Figure::bad_samples || plot.figure == Figure::zero_set_vertices;
      const std::string value =
          (whole ? grouped(static_cast<std::size_t>(number)) : short_number(number)) + plot.unit;
      const float extent = ui.fonts.mono->CalcTextSizeA(ui.fonts.mono->FontSize, 1e9f, 0, value.c_str()).x;
      widgets::draw_text(list, ui.fonts.mono, {high.x - extent - ui.px(10), low.y + ui.px(5)},
                         to_u32(plot.color), value);
    }
    list.PopClipRect();
  }
}

void TimelinePane::draw(Ui& ui) {
  if (range_.fits) range_.fit(ui.model.live_step());
  tabs(ui);
  switch (ui.model.settings.panes.tab) {
  case 1:
    plots(ui);
    break;
  case 2:
    events_.draw(ui);
    break;
  default:
    timeline(ui);
    break;
  }
}

} // namespace isoscope
