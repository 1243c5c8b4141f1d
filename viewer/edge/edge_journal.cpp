// The edge's event with the number that decided, the sweeps of a repair, its history.
#include "edge/edge_inspector.h"

#include "journal/describe.h"
#include "journal/vocabulary.h"
#include "model/words.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <utility>

namespace isoscope::panels {
namespace {

/// Once for each gate at which one comes to stand: the wheel stays free afterwards.
bool gate_reached(const Ui& ui) {
  const int gate = static_cast<int>(ui.window.place.gate) + 1 +
                   1000 * static_cast<int>(ui.window.place.gate_event.value_or(0) % 100000);
  int& shown = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("gate shown"), 0);
  return std::exchange(shown, gate) != gate;
}

/// A number against its limit, as a bar where the limit leaves room for one.
void measured_row(const Ui& ui, std::string_view label, const Measured& m) {
  if (!m.number) return;
  const bool good = m.upper ? m.value <= m.limit : m.value > m.limit;
  if (m.limit > 0)
    widgets::limit_bar(ui, label, m.value, m.limit, good, m.unit, m.upper);
  else
    widgets::value_row(ui, label, short_number(m.value) + (*m.unit ? " " : "") + m.unit,
                       good ? ui.colors.good_text : ui.colors.bad_text);
}

/// The largest distance before the repair and after every sweep, against δ.
void distance_curve(const Ui& ui, const RepairDetail& sweeps, double delta) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, high = ui.px(84);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + high}, to_u32(ui.colors.ground, 0.6f), ui.px(5));
  std::vector<double> values{sweeps.front().largest_distance / delta};
  for (const RepairSweep& s : sweeps) values.push_back(s.distance_left / delta);
  const double most = std::max(1.1, *std::max_element(values.begin(), values.end()));
  const auto y_of = [&](double v) {
    return at.y + high - ui.px(6) - static_cast<float>(v / most) * (high - ui.px(14));
  };
  const float limit = y_of(1), step = (width - ui.px(20)) / static_cast<float>(values.size() - 1);
  list.AddLine({at.x, limit}, {at.x + width, limit}, to_u32(ui.colors.text, 0.8f));
  widgets::draw_text(list, ui.fonts.small, {at.x + width - ui.px(14), limit - ui.px(16)},
                     to_u32(ui.colors.quiet), "δ");
  std::vector<ImVec2> line;
  for (std::size_t i = 0; i < values.size(); ++i)
    line.push_back({at.x + ui.px(10) + static_cast<float>(i) * step, y_of(values[i])});
  list.AddPolyline(line.data(), static_cast<int>(line.size()), to_u32(ui.colors.accent), 0, ui.px(1.6f));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool good = values[i] <= 1;
    if (i > 0 && at_gate(ui, i - 1))
      list.AddCircle(line[i], ui.px(8), to_u32(ui.colors.selection), 24, ui.px(2));
    widgets::glyph(ui, line[i], 4, good ? ui.colors.good : ui.colors.bad_text,
                   good ? MarkerShape::disc : MarkerShape::cross);
  }
  ImGui::Dummy({width, high});
}

/// How the transaction ended, in one line.
void repair_end(const Ui& ui, const Event& e, const RepairDetail& sweeps, double delta) {
  const widgets::Row row(ui, 22);
  if (at_gate(ui, sweeps.size())) gate_ground(ui, row.at, {row.width, row.high});
  const bool good = e.kind != EventKind::rejection;
  row.verdict(8, good);
  std::string text =
      good ? "committed: every facet below δ" : "rolled back: " + std::string(words(e.reason).title);
  if (!good && e.value > e.limit && e.limit > 0)
    text += " by " + short_number((e.value - e.limit) / delta) + " δ";
  row.text(ui.fonts.small, 20, ui.colors.text, text);
  row.item();
}

/// The inner level of a transaction.
void repair(Ui& ui, const Event& event, const RepairDetail& sweeps, double delta) {
  if (sweeps.empty()) return;
  widgets::subtitle(ui, "Repair, sweep by sweep");
  distance_curve(ui, sweeps, delta);
  ImGui::PushFont(ui.fonts.mono);
  constexpr std::array<const char*, 5> heads{"sweep", "d / δ", "moved", "flips", "points"};
  if (ImGui::BeginTable("sweeps", 5, ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_RowBg)) {
    ImGui::PushFont(ui.fonts.small);
    ImGui::TableNextRow();
    for (const char* head : heads) {
      ImGui::TableNextColumn();
      ImGui::TextColored(to_vec(ui.colors.quiet), "%s", head);
    }
    ImGui::PopFont();
    const auto row = [&](const std::array<std::string, 5>& cells) {
      ImGui::TableNextRow();
      for (const std::string& cell : cells) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(cell.c_str());
      }
    };
    row({"before", short_number(sweeps.front().largest_distance / delta), "", "", ""});
    for (std::size_t i = 0; i < sweeps.size(); ++i) {
      const RepairSweep& s = sweeps[i];
      row({std::to_string(i + 1), short_number(s.distance_left / delta), grouped(s.moved), grouped(s.flipped),
           grouped(s.points_added)});
      if (at_gate(ui, i)) {
        ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1, to_u32(ui.colors.selection, 0.25f));
        if (gate_reached(ui)) ImGui::SetScrollHereY(0.5f);
      }
    }
    ImGui::EndTable();
  }
  ImGui::PopFont();
  repair_end(ui, event, sweeps, delta);
  widgets::quiet_text(ui,
                      event.kind == EventKind::rejection
                          ? "The worst facet is drawn, with its distance. F11 and F10 go through the sweeps."
                          : "F11 and F10 go through the sweeps; the worst facet after each is drawn.",
                      true);
}

} // namespace

bool at_gate(const Ui& ui, std::size_t gate) {
  return ui.window.place.at_gate(gate);
}

void gate_ground(const Ui& ui, ImVec2 low, ImVec2 size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 from{low.x - ui.px(4), low.y}, to{low.x + size.x + ui.px(4), low.y + size.y};
  list.AddRectFilled(from, to, to_u32(ui.colors.selection, 0.16f), ui.px(4));
  list.AddRectFilled({from.x - ui.px(4), low.y}, {from.x - ui.px(1), to.y}, to_u32(ui.colors.selection));
  if (!gate_reached(ui)) return;
  const float middle = low.y + size.y / 2 - ImGui::GetWindowPos().y, high = ImGui::GetWindowHeight();
  if (middle < 0.1f * high || middle > 0.9f * high) ImGui::SetScrollFromPosY(middle, 0.5f);
}

Measured measured(Measure measure, double value, double limit, double delta) {
  if (measure == Measure::none) return {};
  const bool upper = measure == Measure::length || measure == Measure::error;
  if (is_length(measure)) return {value / delta, limit / delta, "δ", upper, true};
  return {value, limit, "", upper, true};
}

void event_details(Ui& ui, const Journal& journal, std::uint32_t index) {
  const Event& e = journal.events()[index];
  const double delta = journal.parameters_at(e.step).delta;
  ImGui::PushFont(ui.fonts.small);
  widgets::wrapped_text(describe(journal, e));
  ImGui::PopFont();
  const bool repaired =
      e.kind == EventKind::repair || e.kind == EventKind::relaxation || e.kind == EventKind::shake;
  if (e.kind == EventKind::rejection || repaired)
    measured_row(ui, repaired ? "largest d" : words(e.reason).title,
                 measured(measure_of(e), e.value, e.limit, delta > 0 ? delta : 1));
  const bool witnessed = e.kind == EventKind::rejection && squared_length(e.witness) > 0;
  if (witnessed && widgets::link_row(ui, "witness", "witness",
                                     short_number(e.witness.x) + "  " + short_number(e.witness.y) + "  " +
                                         short_number(e.witness.z),
                                     "Marks and frames the point that decided. Key J."))
    ui.commands.post("witness");
  if (e.detail > 0 && e.detail < journal.repairs().size())
    repair(ui, e, journal.repairs()[e.detail], delta > 0 ? delta : 1);
}

void edge_history(Ui& ui, const Journal& journal, VertexId a, VertexId b) {
  constexpr std::size_t most = 8, reach = 200000;
  std::vector<std::uint32_t> found;
  const auto own = ui.window.selected_event();
  const auto& range = ui.window.range;
  const std::size_t end = journal.events().size();
  for (std::size_t i = end; i > end - std::min(end, reach) && found.size() < most; --i) {
    const Event& e = journal.events()[i - 1];
    if (range && !range->holds(e.step)) continue;
    if (own == i - 1) continue; // it stands above
    if ((e.vertex == a && e.other == b) || (e.vertex == b && e.other == a))
      found.push_back(static_cast<std::uint32_t>(i - 1));
  }
  if (found.empty()) return;
  widgets::subtitle(ui, own ? "In the journal, at other steps" : "In the journal");
  for (const std::uint32_t index : found) {
    const Event& e = journal.events()[index];
    const std::string what = e.kind == EventKind::rejection ? "stayed: " + std::string(words(e.reason).title)
                             : e.kind == EventKind::repair  ? std::string("collapsed with repair")
                                                            : std::string("collapsed");
    if (widgets::link_row(ui, "event", what, "step " + grouped(step_showing(e)), describe(journal, e), index))
      ui.commands.post("event", {std::to_string(index)});
  }
}

} // namespace isoscope::panels
