// The verdict, and every check with its number beside its limit.
#include "edge/edge_inspector.h"

#include "edge/edge_journal.h"
#include "edge/edge_numbers.h"
#include "edge/edge_what_if.h"
#include "model/words.h"
#include "scene/pick_geometry.h"
#include "scene/reason_style.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope::panels {
namespace {

using CheckState = CheckVerdict::State;

std::string edge_text(std::uint32_t a, std::uint32_t b) {
  return std::to_string(a) + " – " + std::to_string(b);
}

std::string_view kind_text(EdgeKind kind) {
  constexpr std::array<std::string_view, 4> words{"an edge of ∂Γ", "an edge of Z", "between Z and Γ",
                                                  "of no kind that is collapsed"};
  return words.at(static_cast<std::size_t>(kind));
}

/// A glyph and a sentence in one line.
void headline(const Ui& ui, Rgb color, MarkerShape shape, std::string_view text) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float high = ui.px(26), width = ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + high}, to_u32(color, 0.18f), ui.px(5));
  widgets::glyph(ui, {at.x + ui.px(14), at.y + high / 2}, 5.5f, color, shape);
  ImGui::PushFont(ui.fonts.bold);
  const std::string shown = widgets::fitted(text, width - ui.px(34));
  const float extent = widgets::text_size(shown).y;
  ImGui::PopFont();
  widgets::draw_text(list, ui.fonts.bold, {at.x + ui.px(27), at.y + (high - extent) / 2},
                     to_u32(ui.colors.text), shown);
  ImGui::Dummy({width, high});
}

void verdict(Ui& ui, const EdgeXray& x) {
  const CollapseAttempt& attempt = x.attempt;
  const bool eligible = attempt.check(CollapseCheck::eligible).state == CheckState::passed;
  if (!eligible)
    headline(ui, ui.colors.quiet, MarkerShape::circle, "is never collapsed");
  else if (attempt.possible())
    headline(ui, ui.colors.good, MarkerShape::disc,
             "can collapse: " + std::string(reason_style(attempt.found_by).title));
  else
    headline(ui, reason_style(attempt.rejected).color, reason_style(attempt.rejected).shape,
             "stays: " + std::string(reason_style(attempt.rejected).title));
  if (x.agrees) {
    ImGui::PushFont(ui.fonts.small);
    widgets::verdict_glyph(ui, *x.agrees);
    ImGui::SameLine();
    ImGui::TextUnformatted(*x.agrees ? "the journal says the same, numbers and all"
                                     : "the journal says otherwise");
    ImGui::PopFont();
    widgets::tip(ui, "Judged again",
                 "The evaluator that the run used, asked again about the state of that moment.");
  }
  constexpr std::array<const char*, 4> labels{"automatic", "halfedge", "general", "octree"};
  int chosen = static_cast<int>(ui.window.selection.target);
  ImGui::PushFont(ui.fonts.small);
  if (widgets::segmented(ui, "targets", labels, chosen))
    ui.window.selection.target = static_cast<XrayTarget>(chosen);
  ImGui::PopFont();
  widgets::tip(ui, "Which targets",
               "As the stage looks for them, the ends of the edge alone, the search, or the paper's octree.");
}

std::string time_text(double seconds) {
  return seconds < 1e-3 ? short_number(1e6 * seconds) + " µs" : short_number(1e3 * seconds) + " ms";
}

/// One rung of the ladder; a click shows the witness.
void check_row(Ui& ui, const EdgeXray& x, CollapseCheck check) {
  const CheckVerdict& v = x.attempt.check(check);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0f), high = ui.px(22);
  ImGui::PushID(static_cast<int>(check));
  const bool asked = v.state != CheckState::skipped;
  const bool pressed = ImGui::InvisibleButton("check", {width, high});
  ImGui::PopID();
  const bool has_witness = witness_of(x, x.attempt, check).has_value();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (at_gate(ui, static_cast<std::size_t>(check))) gate_ground(ui, at, {width, high});
  if (ImGui::IsItemHovered() && has_witness) {
    list.AddRectFilled({at.x - ui.px(4), at.y}, {at.x + width + ui.px(4), at.y + high},
                       to_u32(ui.colors.hover), ui.px(4));
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  if (pressed && has_witness) ui.commands.post("witness", {std::string(name(check))});
  widgets::tip(ui, check_title(check),
               std::string(check_help(check)) + (has_witness ? " Click for the witness." : "") +
                   (v.seconds > 0 ? " It took " + time_text(v.seconds) + "." : ""));
  const ImVec2 mark{at.x + ui.px(8), at.y + high / 2};
  if (v.state == CheckState::passed)
    widgets::glyph(ui, mark, 4.5f, ui.colors.good, MarkerShape::disc);
  else if (v.state == CheckState::failed)
    widgets::glyph(ui, mark, 4.5f, ui.colors.bad_text, MarkerShape::cross);
  else
    widgets::glyph(ui, mark, 3.5f, ui.colors.quiet, MarkerShape::circle);
  const float y = at.y + (high - ui.fonts.small->FontSize) / 2;
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(20), y},
                     to_u32(asked ? ui.colors.text : ui.colors.quiet), check_title(check));
  const double delta = x.criteria.delta > 0 ? x.criteria.delta : 1;
  const std::string value = asked ? check_text(check, v, x.attempt, delta) : "not asked";
  const float extent = widgets::width_of(ui.fonts.mono, value);
  widgets::draw_text(list, ui.fonts.mono,
                     {at.x + width - extent, at.y + (high - ui.fonts.mono->FontSize) / 2},
                     to_u32(!asked                          ? ui.colors.quiet
                            : v.state == CheckState::failed ? ui.colors.bad_text
                                                            : ui.colors.text,
                            asked ? 1.0f : 0.7f),
                     value);
  if (v.seconds > 0) {
    const std::string time = time_text(v.seconds);
    const float room = std::max(extent, ui.px(104)) + ui.px(10);
    const float taken = widgets::width_of(ui.fonts.small, time);
    widgets::draw_text(list, ui.fonts.small, {at.x + width - room - taken, y}, to_u32(ui.colors.quiet, 0.8f),
                       time);
  }
  ImGui::SetCursorScreenPos({at.x, at.y + high});
}

void ladder(Ui& ui, const EdgeXray& x) {
  widgets::subtitle(ui, "Checks");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), 0});
  double seconds = 0;
  for (std::size_t i = 0; i < collapse_check_count; ++i) {
    check_row(ui, x, static_cast<CollapseCheck>(i));
    seconds += x.attempt.checks[i].seconds;
  }
  ImGui::PopStyleVar();
  widgets::quiet_text(ui, "all of it in " + time_text(seconds));
}

void offenders(Ui& ui, const LinkVerdict& link) {
  const std::array<const std::vector<std::vector<VertexId>>*, 2> lists{&link.offending_t,
                                                                       &link.offending_zero};
  if (lists[0]->empty() && lists[1]->empty()) return;
  widgets::subtitle(ui, "In both links, not in that of the edge");
  constexpr std::size_t most = 6;
  int id = 0;
  std::size_t left_out = 0;
  for (std::size_t k = 0; k < lists.size(); ++k)
    for (std::size_t i = 0; i < lists.at(k)->size(); ++i) {
      const auto& simplex = (*lists.at(k))[i];
      if (i >= most || simplex.empty()) {
        ++left_out;
        continue;
      }
      std::string numbers;
      for (const VertexId v : simplex) numbers += (numbers.empty() ? "" : " ") + std::to_string(v.value);
      const char* what = simplex.size() == 1 ? "vertex" : simplex.size() == 2 ? "edge" : "triangle";
      ImGui::PushID(id++);
      if (widgets::link_row(ui, "offender", std::string(what) + (k == 0 ? " of T" : " of Z"), numbers,
                            "A collapse would pinch here; drawn in magenta. Click selects its first vertex."))
        ui.commands.post("pick", {"vertex", std::to_string(simplex[0].value)});
      ImGui::PopID();
    }
  if (left_out > 0) widgets::quiet_text(ui, "and " + grouped(left_out) + " more");
}

} // namespace

void edge_details(Ui& ui, EdgeProbe& probe, const StateSnapshot& s) {
  const WindowState& m = ui.window;
  const Pick& picked = m.selection.picked;
  const auto xray = probe.xray();
  const auto ends = edge_positions(s, picked);
  const double delta = s.criteria.delta > 0 ? s.criteria.delta : 1;
  std::string note = xray ? std::string(kind_text(xray->attempt.kind)) : std::string("an edge of Z");
  if (ends) note += ", " + short_number(distance((*ends)[0], (*ends)[1]) / delta) + " δ long";
  if (xray && xray->before) note += ", before the operation";
  widgets::heading(ui, icon::bolt, "Edge " + edge_text(picked.id, picked.other), note);
  for (const std::uint32_t end : {picked.id, picked.other}) {
    ImGui::PushID(static_cast<int>(end));
    const bool alive = end < s.complex.vertices.size() && s.complex.vertices[end].alive;
    if (widgets::link_row(ui, "vertex", alive ? "vertex" : "vertex, gone", grouped(end),
                          "Selects the vertex."))
      ui.commands.post("pick", {"vertex", std::to_string(end)});
    ImGui::PopID();
  }
  const auto event = m.selected_event();
  if (xray) verdict(ui, *xray);
  // What is tried comes first: it is what changes.
  const bool tried = m.selection.what_if.has_value();
  if (xray && tried) what_if(ui, probe, *xray);
  if (event) {
    ImGui::Dummy({0, ui.px(2)});
    event_details(ui, *m.run.journal, *event);
  }
  if (xray) {
    ladder(ui, *xray);
    offenders(ui, xray->attempt.link);
    if (!tried) what_if(ui, probe, *xray);
    candidates(ui, *xray);
    search_regions(ui, *xray);
    kernel(ui, *xray);
    cost(ui, *xray, probe.study().get());
    unlock(ui, probe);
  } else if (probe.looking()) {
    widgets::quiet_text(ui, "The edge is being looked at.");
  } else if (s.complex.form == ZeroForm::free) {
    widgets::quiet_text(
        ui, "Z has left T: there is no kernel to look into. The journal tells what was tried.", true);
  } else {
    widgets::quiet_text(ui, "T has no such edge at this step.", true);
  }
  if (m.run.journal) edge_history(ui, *m.run.journal, VertexId(picked.id), VertexId(picked.other));
}

} // namespace isoscope::panels
