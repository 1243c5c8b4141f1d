// The plots: vertices of Z with stage marks (Figure 21), tetrahedra, rejections by reason, figures of the
// refinement; over steps or seconds.
#include "base/numbers.h"
#include "journal/vocabulary.h"
#include "model/words.h"
#include "timeline/timeline_panel.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace isoscope {

struct TimelinePane::Plot {
  const char* name;
  Figure figure;
  Rgb color;
  bool whole; ///< a count
  const char* unit;
  float weight;       ///< of its width
  bool ruled = false; ///< with lines and numbers of the axis
};

namespace {

constexpr float title_high = 24;
constexpr double decade = 10;

/// A vertical axis, logarithmic where the values span more than a decade.
struct Axis {
  double least = 0, most = 1;
  bool logarithmic = false;
  double shown(double v) const { return logarithmic ? std::log10(std::max(v, 1e-3)) : v; }
  float y(double v, float top, float bottom) const {
    const double reach = std::max(shown(most) - shown(least), 1e-9);
    const double part = std::clamp((shown(v) - shown(least)) / reach, 0.0, 1.0);
    return bottom - static_cast<float>(part) * (bottom - top);
  }
};

Axis axis_for(double least, double most) {
  Axis axis{least, most, least > 0 && most / least > decade};
  if (!axis.logarithmic && least > 0 && least < 0.5 * most) axis.least = 0;
  return axis;
}

/// Of the plot that has an axis: units of the interface at its left.
constexpr float axis_room = 50;

/// Lines across the plot, their numbers in the room at its left; those that would touch are left out.
void axis_numbers(const Ui& ui, const Axis& axis, ImVec2 low, ImVec2 size, float top, float bottom) {
  std::vector<double> ticks;
  if (axis.logarithmic) {
    for (double d = std::pow(decade, std::floor(std::log10(axis.least))); d <= axis.most; d *= decade)
      for (const double part : {1.0, 2.0, 5.0})
        if (part * d >= axis.least && part * d <= axis.most) ticks.push_back(part * d);
    // Powers of ten come first where there is no room for all.
    std::stable_sort(ticks.begin(), ticks.end(), [](double a, double b) {
      const auto rank = [](double v) { return std::log10(v) == std::floor(std::log10(v)) ? 0 : 1; };
      return rank(a) < rank(b);
    });
  } else {
    const double span = std::max(axis.most - axis.least, 1.0), wanted = span / 4;
    const double power = std::pow(decade, std::floor(std::log10(wanted)));
    const double step = std::max((wanted / power > 5 ? 10 : wanted / power > 2 ? 5 : 2) * power, 1.0);
    for (double v = std::ceil(axis.least / step) * step; v <= axis.most; v += step) ticks.push_back(v);
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float line = ui.fonts.small->FontSize;
  std::vector<float> taken;
  for (const double v : ticks) {
    const float y = axis.y(v, top, bottom);
    const bool touches = std::any_of(taken.begin(), taken.end(),
                                     [&](float other) { return std::abs(other - y) < line + ui.px(2); });
    if (touches || y - line / 2 < low.y + ui.px(20)) continue;
    taken.push_back(y);
    list.AddLine({low.x, y}, {low.x + size.x, y}, to_u32(ui.colors.line));
    const std::string text = grouped(static_cast<std::size_t>(v));
    const float width = widgets::width_of(ui.fonts.small, text);
    widgets::draw_text(list, ui.fonts.small, {low.x - width - ui.px(6), y - line / 2},
                       to_u32(ui.colors.quiet), text);
  }
}

/// The estimate of how few vertices the finished mesh could have, where there is one.
std::optional<double> optimum_of(const WindowState& m) {
  if (!m.run.scene || !m.run.scene->optimum) return std::nullopt;
  return m.run.scene->optimum->vertices;
}

/// A broken line, with what it is at its left end.
void optimum_line(const Ui& ui, double optimum, float y, float left, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float dash = ui.px(5);
  for (float x = left; x < left + width; x += 2 * dash)
    list.AddLine({x, y}, {std::min(x + dash, left + width), y}, to_u32(ui.colors.good_text), ui.px(1.2f));
  widgets::draw_text(list, ui.fonts.small, {left + ui.px(4), y + ui.px(2)}, to_u32(ui.colors.good_text),
                     "asymptotic optimum, about " + grouped(static_cast<std::size_t>(std::round(optimum))));
}

/// The number at the step shown, at the right of a plot's title; its width.
float plot_value(const Ui& ui, ImVec2 low, ImVec2 size, Rgb color, const std::string& value) {
  const float extent = widgets::width_of(ui.fonts.mono, value);
  widgets::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.mono,
                     {low.x + size.x - extent - ui.px(10), low.y + ui.px(5)}, to_u32(color), value);
  return extent;
}

} // namespace

double TimelinePane::time_at(double step) const {
  // seconds[k] is the time after operation k, that is at step k + 1.
  const auto k = static_cast<std::size_t>(std::clamp(step, 0.0, static_cast<double>(seconds_->size())));
  return k == 0 ? 0.0 : static_cast<double>((*seconds_)[k - 1]);
}

double TimelinePane::part_of(double step) const {
  if (seconds_ == nullptr || seconds_->empty())
    return (step - range_.begin) / std::max(range_.end - range_.begin, 1e-9);
  const double begin = time_at(range_.begin), end = time_at(range_.end);
  return (time_at(step) - begin) / std::max(end - begin, 1e-9);
}

double TimelinePane::from_part(double part) const {
  if (seconds_ == nullptr || seconds_->empty()) return range_.begin + part * (range_.end - range_.begin);
  double low = range_.begin, high = range_.end;
  while (high - low > 0.5) {
    const double middle = 0.5 * (low + high);
    (part_of(middle) < part ? low : high) = middle;
  }
  return high;
}

std::string TimelinePane::extent_words() const {
  if (seconds_ == nullptr || seconds_->empty())
    return " over " + grouped(static_cast<std::size_t>(std::max(range_.end - range_.begin, 0.0))) + " steps";
  return " over " + short_number(time_at(range_.end) - time_at(range_.begin)) + " s";
}

void TimelinePane::axis_switch(Ui& ui, float left, float y) {
  constexpr std::array<const char*, 2> labels{"steps", "seconds"};
  const float width = ui.px(150), right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (right - width < left) return;
  const ImVec2 before = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({right - width, y});
  int chosen = ui.window.plot_time ? 1 : 0;
  ImGui::PushFont(ui.fonts.small);
  if (widgets::segmented(ui, "axis", labels, chosen, width)) ui.window.plot_time = chosen == 1;
  ImGui::PopFont();
  ImGui::SetCursorScreenPos(before);
}

void TimelinePane::stage_marks(const Ui& ui, ImVec2 low, ImVec2 size, bool named) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float free_from = low.x;
  for (const JournalIndex::StageSpan& span : ui.window.index.stages()) {
    const float x = std::round(low.x + static_cast<float>(part_of(span.begin)) * size.x);
    if (x < low.x || x > low.x + size.x) continue;
    const Rgb color = stage_color(ui.theme, span.stage);
    list.AddLine({x, low.y}, {x, low.y + size.y}, to_u32(color, 0.75f), ui.px(1));
    const std::string_view title = words(span.stage).title;
    const float extent = widgets::width_of(ui.fonts.small, title);
    if (!named || span.end <= span.begin + 1 || x + ui.px(3) < free_from ||
        x + extent + ui.px(4) > low.x + size.x)
      continue;
    widgets::draw_text(list, ui.fonts.small, {x + ui.px(3), low.y + size.y - ui.px(16)},
                       to_u32(ui.colors.quiet), title);
    free_from = x + extent + ui.px(8);
  }
}

float TimelinePane::plot_curve(const Ui& ui, const Plot& plot, ImVec2 low, ImVec2 size) const {
  const WindowState& m = ui.window;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::vector<float>& values = m.index.values(plot.figure);
  const float top = low.y + ui.px(title_high), bottom = low.y + size.y - ui.px(plot.ruled ? 18 : 6);
  const auto first = static_cast<std::size_t>(range_.begin);
  const std::size_t last = std::min(values.size(), static_cast<std::size_t>(range_.end) + 1);
  // T is gone once Z has left it, and with it what is measured on it; ε and heights are those of f, which
  // ends where Z goes into T.
  const bool of_f = plot.figure == Figure::largest_error || plot.figure == Figure::smallest_height;
  const auto absent = [&](std::size_t k) {
    const Stage stage = m.index.stage(static_cast<Step>(k));
    if (of_f) return stage != Stage::setup && stage != Stage::refinement && stage != Stage::gamma;
    return plot.figure != Figure::zero_set_vertices && stage == Stage::improve;
  };
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t k = first; k < last; ++k)
    if (std::isfinite(values[k]) && (plot.whole || values[k] > 0) && !absent(k)) {
      least = std::min(least, static_cast<double>(values[k]));
      most = std::max(most, static_cast<double>(values[k]));
    }
  if (last <= first || most < least) return 0;
  const std::optional<double> optimum =
      plot.figure == Figure::zero_set_vertices ? optimum_of(m) : std::nullopt;
  if (optimum) least = std::min(least, *optimum);
  const Axis axis = axis_for(std::max(least, plot.whole ? 1.0 : 1e-3), std::max(most, 1e-3));
  if (plot.ruled) axis_numbers(ui, axis, low, size, top, bottom);
  // Two values a pixel pair where steps are dense, each step once where they are not.
  const auto columns = static_cast<std::size_t>(size.x);
  std::vector<ImVec2> line;
  const std::size_t stride = std::max<std::size_t>(1, (last - first) / std::max<std::size_t>(2 * columns, 1));
  for (std::size_t k = first; k < last; k += stride) {
    if (!std::isfinite(values[k]) || absent(k)) continue;
    const float x = low.x + static_cast<float>(part_of(static_cast<double>(k + 1))) * size.x;
    line.push_back({x, axis.y(static_cast<double>(values[k]), top, bottom)});
  }
  list.AddPolyline(line.data(), static_cast<int>(line.size()), to_u32(plot.color), 0, ui.px(1.6f));
  if (optimum) optimum_line(ui, *optimum, axis.y(*optimum, top, bottom), low.x, size.x);
  const Step step = m.transport.step();
  if (step == 0 || step > values.size()) return 0;
  if (absent(step - 1)) return plot_value(ui, low, size, ui.colors.quiet, "–");
  const auto number = static_cast<double>(values[step - 1]);
  std::string value =
      (plot.whole ? grouped(static_cast<std::size_t>(number)) : short_number(number)) + plot.unit;
  if (optimum) value += " = " + fixed(number / *optimum, 2) + " × the optimum";
  return plot_value(ui, low, size, plot.color, value);
}

// How many edges each reason has rejected so far; all on one logarithmic axis.
float TimelinePane::plot_rejections(const Ui& ui, ImVec2 low, ImVec2 size) const {
  const JournalIndex& index = ui.window.index;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float top = low.y + ui.px(title_high), bottom = low.y + size.y - ui.px(6);
  std::uint32_t most = 1, all = 0;
  for (const Reason reason : rejecting_reasons) {
    most = std::max(most, index.rejections(reason, 0, index.steps() + 1));
    all += index.rejections(reason, 0, ui.window.transport.step() + 1);
  }
  const Axis axis{1, static_cast<double>(std::max(most, 2u)), most > decade};
  const int columns = std::max(2, static_cast<int>(size.x / ui.px(2)));
  for (const Reason reason : rejecting_reasons) {
    if (index.rejections(reason).empty()) continue;
    std::vector<ImVec2> line;
    for (int i = 0; i <= columns; ++i) {
      const double part = static_cast<double>(i) / columns;
      const auto step = static_cast<Step>(std::max(from_part(part), 0.0));
      const auto n = index.rejections(reason, 0, step + 1);
      if (n == 0) continue;
      line.push_back({low.x + static_cast<float>(part) * size.x, axis.y(n, top, bottom)});
    }
    if (line.size() > 1)
      list.AddPolyline(line.data(), static_cast<int>(line.size()), to_u32(words(reason).color), 0,
                       ui.px(1.5f));
    if (!line.empty())
      widgets::glyph(ui, {std::min(line.back().x, low.x + size.x - ui.px(6)), line.back().y}, 4,
                     words(reason).color, words(reason).shape);
  }
  const std::string value = grouped(all);
  return plot_value(ui, low, size, ui.colors.text, value);
}

void TimelinePane::plots(Ui& ui) {
  const WindowState& m = ui.window;
  seconds_ = m.plot_time ? &m.index.values(Figure::seconds) : nullptr;
  std::vector<Plot> all{{"vertices of Z", Figure::zero_set_vertices, ui.colors.text, true, "", 2.2f, true},
                        {"tetrahedra", Figure::tets, ui.colors.accent_text, true, "", 1},
                        {"bad samples", Figure::bad_samples, ui.colors.bad_text, true, "", 1},
                        {"largest ε", Figure::largest_error, ui.colors.warning_text, false, "", 1},
                        {"smallest height", Figure::smallest_height, ui.colors.good_text, false, " δ", 1}};
  bool rejections = false;
  for (const Reason reason : rejecting_reasons)
    rejections = rejections || !m.index.rejections(reason).empty();
  if (rejections) all.pop_back(); // heights belong to the refinement alone
  constexpr float rejection_weight = 1.7f;
  float weights = rejections ? rejection_weight : 0;
  for (const Plot& plot : all) weights += plot.weight;
  const std::size_t cards = all.size() + (rejections ? 1 : 0);
  const ImVec2 origin = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float gap = ui.px(8), unit = (room.x - static_cast<float>(cards - 1) * gap) / weights;
  if (unit < ui.px(50) || room.y < ui.px(40)) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float x = origin.x;
  const std::string extent = extent_words();
  const auto card = [&](const char* name, float weight, bool named, auto&& draw) {
    const ImVec2 low{x, origin.y}, size{weight * unit, room.y}, high{low.x + size.x, low.y + size.y};
    const float axis = named ? ui.px(axis_room) : 0;
    const ImVec2 from{low.x + axis, low.y}, inner{std::max(size.x - axis, 1.0f), size.y};
    ImGui::PushID(name);
    scrub(ui, "plot", from, inner);
    ImGui::PopID();
    list.AddRectFilled(low, high, to_u32(ui.colors.ground, 0.6f), ui.px(5));
    list.PushClipRect(low, high, true);
    stage_marks(ui, {from.x, from.y + ui.px(20)}, {inner.x, inner.y - ui.px(20)}, named);
    const float taken = draw(from, inner);
    const float head = std::round(from.x + static_cast<float>(part_of(m.transport.step())) * inner.x);
    list.AddLine({head, low.y + ui.px(20)}, {head, high.y}, to_u32(ui.colors.selection), ui.px(1.5f));
    const widgets::Font font(ui.fonts.small);
    widgets::draw_text(
        list, ui.fonts.small, {low.x + ui.px(10), low.y + ui.px(5)}, to_u32(ui.colors.quiet),
        widgets::fitted(named ? name + extent : name, std::max(size.x - taken - ui.px(26), 1.0f)));
    list.PopClipRect();
    x = high.x + gap;
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    card(all[i].name, all[i].weight, all[i].ruled,
         [&](ImVec2 low, ImVec2 size) { return plot_curve(ui, all[i], low, size); });
    if (rejections && i == 1)
      card("edges that stayed, by reason", rejection_weight, false,
           [&](ImVec2 low, ImVec2 size) { return plot_rejections(ui, low, size); });
  }
  seconds_ = nullptr;
}

} // namespace isoscope
