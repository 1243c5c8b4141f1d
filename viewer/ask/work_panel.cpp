// Where the work goes, in three columns: the busiest places, time by reason, the last attempts.
#include "ask/investigation.h"

#include "journal/vocabulary.h"
#include "model/words.h"
#include "scene/annotation.h"
#include "ui/widgets.h"

#include <algorithm>
#include <optional>

namespace isoscope::panels {
namespace {

constexpr std::size_t most_places = 10;

std::string reason_text(Reason reason) {
  return std::string(rejects(reason) ? words(reason).title : name(reason));
}

void places(Ui& ui, const WorkMap& map, const char* which) {
  for (std::size_t i = 0; i < std::min(most_places, map.cells.size()); ++i) {
    const WorkCell& c = map.cells[i];
    if (widgets::link_row(ui, "place", std::to_string(i + 1) + "  " + reason_text(c.reason), grouped(c.count),
                          "A cube of one δ; its most frequent reason and how often it was worked in. The "
                          "camera goes there.",
                          i))
      ui.commands.post("look-at-place", {which, std::to_string(i)});
  }
}

/// What the colours of the cells stand for.
void heat_legend(const Ui& ui, std::size_t most) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, high = ui.px(8), part = width / 3;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i + 1 < heat_stops.size(); ++i) {
    const ImU32 a = to_u32(heat_stops[i]), b = to_u32(heat_stops[i + 1]);
    const float x = at.x + part * static_cast<float>(i);
    list.AddRectFilledMultiColor({x, at.y}, {x + part, at.y + high}, a, b, b, a);
  }
  const std::string end = grouped(most) + " in a cell";
  const float extent = widgets::width_of(ui.fonts.small, end);
  const float y = at.y + high + ui.px(2);
  widgets::draw_text(list, ui.fonts.small, {at.x, y}, to_u32(ui.colors.quiet), "1");
  widgets::draw_text(list, ui.fonts.small, {at.x + width - extent, y}, to_u32(ui.colors.quiet), end);
  ImGui::Dummy({width, high + ui.px(4) + ui.fonts.small->FontSize});
}

void map_column(Ui& ui, WorkKind& kind, const WorkAnswer& w) {
  widgets::bold_text(ui, "Busiest places");
  constexpr std::array<const char*, 3> kinds{"insertions", "attempts", "rejections"};
  int chosen = static_cast<int>(kind);
  if (widgets::segmented(ui, "kind", kinds, chosen)) kind = static_cast<WorkKind>(chosen);
  widgets::quiet_text(ui, grouped(w.map.total) + " in " + grouped(w.map.cells.size()) + " cells");
  if (!w.map.cells.empty()) heat_legend(ui, w.map.cells.front().count);
  places(ui, w.map, "work");
}

void time_column(Ui& ui, const WorkAnswer& w) {
  widgets::bold_text(ui, "Time by stage and reason");
  double all = 0;
  for (const WorkTime& t : w.times) all += t.seconds;
  widgets::quiet_text(ui, short_number(all) + " s; between two operations shared evenly", true);
  std::optional<Stage> stage;
  for (std::size_t i = 0; i < w.times.size(); ++i) {
    const WorkTime& t = w.times[i];
    if (t.stage != stage) {
      stage = t.stage;
      double sum = 0;
      for (const WorkTime& other : w.times) sum += other.stage == t.stage ? other.seconds : 0;
      widgets::value_row(ui, words(t.stage).title, short_number(sum) + " s", ui.colors.accent_text);
    }
    widgets::value_row(ui, "   " + std::string(name(t.kind)) + ", " + reason_text(t.reason),
                       grouped(t.count) + " ×   " + short_number(t.seconds) + " s");
  }
}

/// The reasons of the last attempts as a band stacked by share, oldest on the left.
void band(const Ui& ui, const StallReport& s) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, high = ui.px(44);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + high}, to_u32(ui.colors.raised), ui.px(3));
  const float column = width / static_cast<float>(std::max<std::size_t>(1, s.over_time.size()));
  for (std::size_t k = 0; k < s.over_time.size(); ++k) {
    std::uint32_t all = 0;
    for (const std::uint32_t n : s.over_time[k]) all += n;
    if (all == 0) continue;
    float y = at.y + high;
    for (std::size_t r = 0; r < s.over_time[k].size(); ++r) {
      const std::uint32_t n = s.over_time[k][r];
      if (n == 0) continue;
      const float part = high * static_cast<float>(n) / static_cast<float>(all);
      const float x = at.x + static_cast<float>(k) * column;
      const Rgb color = r == 0 ? ui.colors.good : words(static_cast<Reason>(r)).color;
      list.AddRectFilled({x, y - part}, {x + column - 1, y}, to_u32(color, 0.9f));
      y -= part;
    }
  }
  ImGui::Dummy({width, high});
}

void stall_column(Ui& ui, const WorkAnswer& w) {
  const StallReport& s = w.stall;
  widgets::bold_text(ui, "Why is nothing accepted?");
  widgets::quiet_text(ui,
                      grouped(s.accepted) + " of the last " + grouped(s.attempts) + " attempts accepted; " +
                          grouped(s.since_accepted) + " since the last one",
                      true);
  band(ui, s);
  std::vector<std::size_t> order;
  for (std::size_t r = 0; r < s.by_reason.size(); ++r)
    if (s.by_reason[r] > 0) order.push_back(r);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return s.by_reason[a] > s.by_reason[b]; });
  for (const std::size_t r : order) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ReasonWords& style = words(static_cast<Reason>(r));
    widgets::glyph(ui, {at.x + ui.px(7), at.y + ui.px(10)}, 4.5f, r == 0 ? ui.colors.good : style.color,
                   r == 0 ? MarkerShape::disc : style.shape);
    ImGui::SetCursorScreenPos({at.x + ui.px(20), at.y});
    widgets::value_row(ui, r == 0 ? "accepted" : reason_text(static_cast<Reason>(r)),
                       grouped(s.by_reason[r]));
  }
  if (s.places.cells.empty()) return;
  ImGui::Dummy({0, ui.px(4)});
  widgets::quiet_text(ui, "hottest places of the rejections");
  places(ui, s.places, "stall");
}

} // namespace

void work_tab(Ui& ui, Investigation& asked) {
  const auto work = asked.work();
  if (!work)
    return widgets::quiet_text(ui, ui.window.running() ? "Measured when the run rests."
                                                       : "The journal is being read …");
  const float gap = ui.px(24), width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const auto column = [&](const char* id, auto draw) {
    if (ImGui::BeginChild(id, {width, 0})) draw();
    ImGui::EndChild();
  };
  column("map", [&] { map_column(ui, asked.work_kind, *work); });
  ImGui::SameLine(0, gap);
  column("time", [&] { time_column(ui, *work); });
  ImGui::SameLine(0, gap);
  column("stall", [&] { stall_column(ui, *work); });
}

} // namespace isoscope::panels
