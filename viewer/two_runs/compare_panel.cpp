// Three columns: parameters and links, the stages side by side, the decisions.
#include "two_runs/comparison.h"

#include "journal/describe.h"
#include "journal/vocabulary.h"
#include "model/words.h"
#include "two_runs/run_views.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace isoscope::panels {
namespace {

constexpr float decision_units = 22;

/// A line of a table: a quiet label, cells flush right in columns of equal width.
template <std::size_t N>
void table_row(const Ui& ui, std::string_view label, const std::array<std::string, N>& cells,
               float label_width, Rgb color = 0, Rgb label_color = 0) {
  const widgets::Row row(ui, 20);
  const float each = (row.width - label_width) / static_cast<float>(N);
  row.fitted(ui.fonts.small, 0, label_color != 0 ? label_color : ui.colors.quiet, label,
             label_width - ui.px(6));
  const widgets::Font mono(ui.fonts.mono);
  for (std::size_t i = 0; i < N; ++i) {
    const std::string text = widgets::fitted(cells[i], each - ui.px(4));
    const float right = row.at.x + label_width + each * static_cast<float>(i + 1);
    widgets::draw_text(row.list, ui.fonts.mono,
                       {right - widgets::width_of(ui.fonts.mono, text), row.y(ui.fonts.mono)},
                       to_u32(color != 0 ? color : ui.colors.text), text);
  }
  ImGui::Dummy({row.width, row.high - ImGui::GetStyle().ItemSpacing.y});
}

void run_line(Ui& ui, const Comparison& m, const ShownRun& run, bool b) {
  const bool active = b == m.active_is_b();
  const widgets::Row row(ui, 19);
  const float badge = run_badge(ui, row.at, b, active) + ui.px(8);
  std::string text(phase_word(run.run.phase));
  if (run.run.result) text += run.run.result->certificate.holds() ? ", certified" : ", not certified";
  text += "  ·  " + grouped(run.live_step()) + " steps";
  if (run.shows_recording()) text = run.run.recording->file.filename().string() + "  ·  " + text;
  row.fitted(ui.fonts.small, badge / ui.scale, active ? ui.colors.text : ui.colors.quiet, text,
             row.width - badge);
  ImGui::Dummy({row.width, ui.px(21) - ImGui::GetStyle().ItemSpacing.y});
}

/// A switch with a label, over as many lines as it takes, that posts its command.
void linked(Ui& ui, const char* label, bool on, const char* command) {
  bool changed = on;
  if (widgets::toggle(ui, command, changed)) ui.commands.post(command);
  widgets::command_tip(ui, command);
  ImGui::SameLine(0, ui.px(8));
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + ui.px(2));
  const widgets::Font font(ui.fonts.small);
  widgets::wrapped_text(label);
}

void parameters_column(Ui& ui, const Comparison& m, const RunComparison* found) {
  run_line(ui, m, *m.run(false), false);
  run_line(ui, m, *m.run(true), true);
  const float label_width = std::min(ui.px(110), 0.45f * ImGui::GetContentRegionAvail().x);
  if (found != nullptr) {
    if (found->parameters.empty() && found->same_samples)
      widgets::quiet_text(ui, "The same parameters.");
    else
      table_row<2>(ui, "differing", {"A", "B"}, label_width, ui.colors.quiet);
    for (const FieldDifference& p : found->parameters) table_row<2>(ui, p.name, {p.a, p.b}, label_width);
    if (!found->same_samples)
      table_row<2>(ui, "samples of ∂Ω", {grouped(found->samples_a), grouped(found->samples_b)}, label_width);
  }
  ImGui::Dummy({0, ui.px(2)});
  const float wide = ImGui::GetContentRegionAvail().x, half = ImGui::GetCursorPosX() + wide / 2;
  linked(ui, "one camera", m.linked_cameras, "link-cameras");
  if (wide >= ui.px(240)) ImGui::SameLine(half);
  linked(ui, "both Z", m.window.view.other_zero.visible, "both-z");
  linked(ui, "play heads together", m.linked_steps, "link-steps");
  ImGui::Dummy({0, ui.px(2)});
  const char* views = m.beside() ? "Hide" : "Two views";
  const float room = ImGui::GetContentRegionAvail().x, third = (room - 2 * ui.px(6)) / 3;
  const float widest = std::max(widgets::text_size("Change").x, widgets::text_size(views).x);
  const bool beside =
      third >= widest + ui.px(12); // else they stand below each other, so that words are whole
  const auto button = [&](const char* label, const char* command) {
    if (widgets::plain_button(ui, label, true, beside ? third : room)) ui.commands.post(command);
    widgets::command_tip(ui, command);
  };
  button("Change", "other-run");
  if (beside) ImGui::SameLine(0, ui.px(6));
  button(views, "side-by-side");
  if (beside) ImGui::SameLine(0, ui.px(6));
  button("Close", "close-other");
}

/// What B has more than A, with its sign.
std::string difference_text(double a, double b, int decimals = 0) {
  const double d = b - a;
  const std::string size =
      decimals > 0 ? fixed(std::abs(d), decimals) : grouped(static_cast<std::size_t>(std::abs(d)));
  if (size == fixed(0, decimals)) return size;
  return (d > 0 ? "+" : "−") + size;
}

/// What is compared of each stage.
struct StageMeasure {
  const char* title;
  double (*value)(const StageStatistics&);
  int decimals;
};
constexpr std::array<StageMeasure, 4> stage_measures{
    {{"vertices of Z", [](const StageStatistics& f) { return static_cast<double>(f.zero_set_vertices); }, 0},
     {"refused", [](const StageStatistics& f) { return static_cast<double>(f.rejections()); }, 0},
     {"seconds", [](const StageStatistics& f) { return static_cast<double>(f.seconds); }, 1},
     {"operations", [](const StageStatistics& f) { return static_cast<double>(f.operations); }, 0}}};

/// A, B and Δ of so many measures.
template <std::size_t N> void stage_table(const Ui& ui, const RunComparison* found) {
  const float label_width = ui.px(74);
  std::array<std::string, N> titles;
  std::array<std::string, 3 * N> heads;
  for (std::size_t k = 0; k < N; ++k) {
    titles.at(k) = stage_measures.at(k).title;
    heads.at(3 * k) = "A";
    heads.at(3 * k + 1) = "B";
    heads.at(3 * k + 2) = "Δ";
  }
  table_row<N>(ui, "", titles, label_width, ui.colors.quiet);
  table_row<3 * N>(ui, "stage", heads, label_width, ui.colors.quiet);
  if (found == nullptr) return;
  for (const StageComparison& s : found->stages) {
    std::array<std::string, 3 * N> cells;
    for (std::size_t k = 0; k < N; ++k) {
      const StageMeasure& m = stage_measures.at(k);
      const auto text = [&](double v) {
        return m.decimals > 0 ? fixed(v, m.decimals) : grouped(static_cast<std::size_t>(v));
      };
      cells.at(3 * k) = s.a ? text(m.value(*s.a)) : "–";
      cells.at(3 * k + 1) = s.b ? text(m.value(*s.b)) : "–";
      cells.at(3 * k + 2) = s.a && s.b ? difference_text(m.value(*s.a), m.value(*s.b), m.decimals) : "–";
    }
    table_row<3 * N>(ui, words(s.stage).title, cells, label_width, 0, stage_color(ui.theme, s.stage));
  }
}

void stages_column(Ui& ui, const RunComparison* found) {
  // A cell holds "12,345"; what does not fit is said.
  const float cells = (ImGui::GetContentRegionAvail().x - ui.px(74)) / ui.px(50);
  if (cells >= 12)
    stage_table<4>(ui, found);
  else if (cells >= 9)
    stage_table<3>(ui, found);
  else if (cells >= 6)
    stage_table<2>(ui, found);
  else
    stage_table<1>(ui, found);
  if (cells < 12)
    widgets::quiet_text(ui,
                        std::string(cells < 6 ? "refused, " : "") + (cells < 9 ? "seconds, " : "") +
                            "operations: in a wider window",
                        true);
  if (found == nullptr) return;
  std::array<std::size_t, reason_count> refused_a{}, refused_b{};
  for (const StageComparison& s : found->stages)
    for (std::size_t r = 0; r < refused_a.size(); ++r) {
      refused_a[r] += s.a ? s.a->rejected[r] : 0;
      refused_b[r] += s.b ? s.b->rejected[r] : 0;
    }
  ImGui::Dummy({0, ui.px(6)});
  const float reasons_width = ui.px(180);
  table_row<3>(ui, "refused, by reason", {"A", "B", "Δ"}, reasons_width, ui.colors.quiet);
  for (std::size_t r = 0; r < refused_a.size(); ++r) {
    if (refused_a[r] == refused_b[r]) continue;
    const auto reason = static_cast<Reason>(r);
    table_row<3>(ui, rejects(reason) ? words(reason).title : name(reason),
                 {grouped(refused_a[r]), grouped(refused_b[r]),
                  difference_text(static_cast<double>(refused_a[r]), static_cast<double>(refused_b[r]))},
                 reasons_width);
  }
}

void side(Ui& ui, const Comparison& m, const std::string& text, bool b) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float badge = run_badge(ui, at, b, b == m.active_is_b());
  ImGui::SetCursorScreenPos({at.x + badge + ui.px(8), at.y});
  ImGui::PushFont(ui.fonts.small);
  widgets::wrapped_text(text);
  ImGui::PopFont();
  const float below = std::max(ImGui::GetCursorScreenPos().y, at.y + ui.px(22));
  ImGui::SetCursorScreenPos({at.x, below});
}

void difference(Ui& ui, const Comparison& m, const RunComparison& found) {
  const auto& d = found.decision ? found.decision : found.measure;
  if (!d) {
    widgets::bold_text(ui, "The runs do not differ");
    return widgets::quiet_text(ui,
                               grouped(found.events_a) + " events, every decision and number is the same.");
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, button = ui.px(96);
  {
    const widgets::Font bold(ui.fonts.bold);
    ImGui::TextUnformatted(
        widgets::fitted(found.decision ? "First differing decision" : "First differing number",
                        width - button - ui.px(10))
            .c_str());
  }
  ImGui::SetCursorScreenPos({at.x + width - button, at.y});
  if (widgets::primary_button(ui, "Go there   D", true, button)) ui.commands.post("first-difference");
  widgets::command_tip(ui, "first-difference");
  ImGui::SetCursorScreenPos({at.x, at.y + ui.px(22)});
  std::string place = "event " + grouped(d->event) + ", after " + grouped(d->step) + " common operations";
  if (found.decision && found.measure)
    place += "; judged by other numbers from event " + grouped(found.measure->event) + " on";
  ImGui::PushFont(ui.fonts.small);
  ImGui::PushStyleColor(ImGuiCol_Text, to_vec(ui.colors.quiet));
  widgets::wrapped_text(place, width - button - ui.px(10));
  ImGui::PopStyleColor();
  ImGui::PopFont();
  side(ui, m, describe(*d, *m.run(false)->run.journal, d->in_a), false);
  side(ui, m, describe(*d, *m.run(true)->run.journal, d->in_b), true);
}

void decision_row(Ui& ui, const Comparison& m, const DecisionTable& table, std::size_t index) {
  const DecisionDifference& d = table.rows[index];
  const Journal &maker = *m.run(!d.made_by_a)->run.journal, &other = *m.run(d.made_by_a)->run.journal;
  const Event& e = maker.events()[d.event];
  widgets::Row row(ui, decision_units);
  if (row.button(index)) ui.commands.post("difference", {std::to_string(index)});
  const bool here = m.row == index;
  if (row.hovered() || here) row.ground(ui.colors.hover, here ? 0.7f : 1.0f);
  row.text(ui.fonts.bold, 4, ui.colors.text, d.made_by_a ? "A" : "B");
  row.list.AddRectFilled({row.at.x + ui.px(20), row.at.y + ui.px(5)},
                         {row.at.x + ui.px(26), row.at.y + row.high - ui.px(5)},
                         to_u32(stage_color(ui.theme, d.stage)), ui.px(2));
  std::string text = describe(maker, e);
  const std::string refusal = d.refusal ? describe(other, other.events()[*d.refusal]) : "";
  if (d.refusal)
    text = std::string(d.made_by_a ? "B" : "A") + " refused it, " +
           std::string(words(other.events()[*d.refusal].reason).title) + ":  " + text;
  row.fitted(ui.fonts.small, 34, ui.colors.text, text, row.width - ui.px(38));
  if (!row.hovered()) return;
  const std::string in_other = std::string("\nIn ") + (d.made_by_a ? "B: " : "A: ") +
                               (refusal.empty() ? "never asked for at this place." : refusal);
  widgets::tip(ui, std::string(d.made_by_a ? "A" : "B") + " alone, " + std::string(words(d.stage).title),
               describe(maker, e) + in_other);
}

void decisions_column(Ui& ui, const Comparison& m, const RunComparison* found) {
  if (found == nullptr) return widgets::quiet_text(ui, "The journals are being compared …");
  difference(ui, m, *found);
  const DecisionTable& table = found->decisions;
  if (table.rows.empty()) return;
  ImGui::Dummy({0, ui.px(2)});
  widgets::quiet_text(ui,
                      "From there on " + grouped(table.both()) + " decisions by both, " +
                          grouped(table.only_a()) + " by A alone, " + grouped(table.only_b()) +
                          " by B alone; G goes through them.",
                      true);
  widgets::rows_in_sight(table.rows.size(), ui.px(decision_units),
                         [&](std::size_t i) { decision_row(ui, m, table, i); });
}

void invitation(Ui& ui) {
  widgets::bold_text(ui, "One run is shown");
  widgets::quiet_text(
      ui,
      "Change α, σ, shrink or anything else under Parameters and run it beside this one, or open a "
      "recording beside it. What a branch (Ctrl+D) leaves can be compared too.",
      true);
  const bool possible = ui.window.run.scene != nullptr;
  if (widgets::primary_button(ui, "Run beside   Ctrl+Shift+Enter", possible)) ui.commands.post("run-beside");
  ImGui::SameLine(0, ui.px(8));
  if (widgets::plain_button(ui, "Open beside…   Ctrl+Shift+O", possible)) ui.commands.post("open-beside");
}

} // namespace

void compare_tab(Ui& ui, const Comparison& m) {
  if (m.other() == nullptr) return invitation(ui);
  const auto found = m.found();
  const float gap = ui.px(22), all = ImGui::GetContentRegionAvail().x - 2 * gap;
  const auto column = [&](const char* id, float share, auto draw) {
    if (ImGui::BeginChild(id, {std::floor(all * share), 0})) draw();
    ImGui::EndChild();
  };
  column("parameters", 0.20f, [&] { parameters_column(ui, m, found.get()); });
  ImGui::SameLine(0, gap);
  column("stages", 0.44f, [&] { stages_column(ui, found.get()); });
  ImGui::SameLine(0, gap);
  column("decisions", 0.36f, [&] { decisions_column(ui, m, found.get()); });
}

} // namespace isoscope::panels
