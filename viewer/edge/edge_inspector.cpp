// The verdict, and every check with its number beside its limit.
#include "edge/edge_inspector.h"

#include "journal/vocabulary.h"
#include "model/words.h"
#include "questions/edge_standing.h"
#include "scene/pick_geometry.h"
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
  const widgets::Row row(ui, 26);
  row.ground(color, 0.18f);
  row.glyph(14, color, shape, 5.5f);
  row.fitted(ui.fonts.bold, 27, ui.colors.text, text, row.width - ui.px(34));
  row.item();
}

void verdict(Ui& ui, const EdgeXray& x) {
  const EdgeVerdict v = edge_verdict(ui, x);
  headline(ui, v.color, v.shape, v.words);
  if (x.agrees) {
    widgets::verdict_text(ui, *x.agrees,
                          *x.agrees ? "the journal says the same, numbers and all"
                                    : "the journal says otherwise");
    widgets::tip(ui, "Judged again",
                 "The evaluator that the run used, asked again about the state of that moment.");
  } else {
    widgets::quiet_text(ui,
                        ui.window.selected_event()
                            ? "judged now with other targets; the journal's own decision stands below"
                            : "judged now, at this step; the run decided nothing about it here",
                        true);
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
  const auto number = static_cast<std::size_t>(check);
  widgets::Row row(ui, 22);
  const bool asked = v.state != CheckState::skipped, failed = v.state == CheckState::failed;
  const bool pressed = row.button(number);
  const bool has_witness = witness_of(x, x.attempt, check).has_value();
  if (at_gate(ui, number)) gate_ground(ui, row.at, {row.width, row.high});
  if (has_witness) row.link();
  if (pressed && has_witness) ui.commands.post("witness", {std::string(name(check))});
  widgets::tip(ui, words(check).title,
               std::string(words(check).help) + (has_witness ? " Click for the witness." : "") +
                   (v.seconds > 0 ? " It took " + time_text(v.seconds) + "." : ""));
  if (asked)
    row.verdict(8, !failed);
  else
    row.glyph(8, ui.colors.quiet, MarkerShape::circle, 3.5f);
  row.text(ui.fonts.small, 20, asked ? ui.colors.text : ui.colors.quiet, words(check).title);
  const double delta = x.criteria.unit();
  const std::string value = asked ? check_text(check, v, x.attempt, delta) : "not asked";
  const float extent = row.value(!asked   ? ui.colors.quiet
                                 : failed ? ui.colors.bad_text
                                          : ui.colors.text,
                                 value, asked ? 1.0f : 0.7f);
  if (v.seconds > 0) {
    const std::string time = time_text(v.seconds);
    const float room = std::max(extent, ui.px(104)) + ui.px(10);
    const float left = row.width - room - widgets::width_of(ui.fonts.small, time);
    // Where there is no room for it the tooltip tells it.
    if (left > ui.px(30) + widgets::width_of(ui.fonts.small, words(check).title))
      row.text(ui.fonts.small, left / ui.scale, ui.colors.quiet, time, 0.8f);
  }
  row.below();
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
  std::size_t id = 0;
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
      if (widgets::link_row(ui, "offender", std::string(what) + (k == 0 ? " of T" : " of Z"), numbers,
                            "A collapse would pinch here; drawn in magenta. Click selects its first vertex.",
                            id++))
        ui.commands.post("pick", {"vertex", std::to_string(simplex[0].value)});
    }
  if (left_out > 0) widgets::quiet_text(ui, "and " + grouped(left_out) + " more");
}

std::string_view stratum_text(Stratum stratum) {
  constexpr std::array<std::string_view, 4> words{"a point", "on a curve", "on a sheet", "off Z"};
  return words.at(static_cast<std::size_t>(stratum));
}

/// What the edge is among the strata of Z.
std::string standing_text(const EdgeStanding& s, bool rooms) {
  std::string sides;
  for (const std::int8_t label : s.labels) sides += (sides.empty() ? "" : ", ") + side_text(label, rooms);
  if (s.strata.edge == Stratum::room) return "on no facet of Z";
  if (s.strata.edge == Stratum::sheet) return (s.kept > 0 ? "in a sheet: " : "in what was cut off: ") + sides;
  if (s.strata.border) return "on the border of Z";
  return "on a curve of " + std::to_string(s.kept + s.dropped) + " sheets: " + sides;
}

void link_row(const Ui& ui, const char* label, LinkAnswer answer, const char* help) {
  const bool asked = answer != LinkAnswer::not_asked, holds = answer == LinkAnswer::holds;
  widgets::Row row(ui, 20);
  row.button(label);
  widgets::tip(ui, label, help);
  if (asked)
    row.verdict(8, holds);
  else
    row.glyph(8, ui.colors.quiet, MarkerShape::circle, 3.5f);
  row.text(ui.fonts.small, 20, asked ? ui.colors.text : ui.colors.quiet, label);
  row.value(!asked  ? ui.colors.quiet
            : holds ? ui.colors.good_text
                    : ui.colors.bad_text,
            !asked  ? "not asked"
            : holds ? "holds"
                    : "fails",
            asked ? 1.0f : 0.7f);
  row.below();
}

/// Where the edge and its ends lie among the strata of Z, and what the link condition was asked in.
void standing(Ui& ui, const EdgeXray& x) {
  if (x.star.form != ZeroForm::embedded) return;
  const EdgeStanding s = edge_standing(x.star, x.attempt.link);
  widgets::subtitle(ui, "Stratum");
  widgets::value_row(ui, "edge", standing_text(s, ui.window.has_rooms()));
  const auto end = [&](VertexId v, Stratum stratum, const char* note) {
    widgets::value_row(ui, "vertex " + std::to_string(v.value), std::string(stratum_text(stratum)) + note);
  };
  end(x.star.a(), s.strata.a, s.strata.pinned() ? ", stays where it is" : "");
  end(x.star.b(), s.strata.b, "");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), 0});
  link_row(ui, "link in T", s.in_t, "Lk(a) ∩ Lk(b) = Lk(ab) among the simplices of T. Figure 6");
  link_row(ui, "link in the sheets", s.in_sheets,
           "The same among the facets between sides, with a dummy vertex joined to their curves; asked where "
           "both ends lie on Z.");
  link_row(ui, "link on the curves", s.on_curves,
           "The same among the curves, with a dummy vertex joined to their points; asked where both ends lie "
           "on curves and the sheets allow it. §4.1, §4.2");
  ImGui::PopStyleVar();
}

} // namespace

EdgeVerdict edge_verdict(const Ui& ui, const EdgeXray& x) {
  const CollapseAttempt& attempt = x.attempt;
  // Without an event of the journal, or with other targets than its own, it is no decision of the run.
  const std::string now = x.agrees ? "" : "now: ";
  if (attempt.check(CollapseCheck::eligible).state != CheckState::passed)
    return {now + "is never collapsed", ui.colors.quiet, MarkerShape::circle};
  if (attempt.possible())
    return {now + (x.agrees ? "collapses: " : "could collapse: ") +
                std::string(words(attempt.found_by).title),
            ui.colors.good, MarkerShape::disc};
  return {now + (x.agrees ? "stays: " : "would stay: ") + std::string(words(attempt.rejected).title),
          words(attempt.rejected).color, words(attempt.rejected).shape};
}

void edge_details(Ui& ui, EdgeProbe& probe, const StateSnapshot& s) {
  const WindowState& m = ui.window;
  const Pick& picked = m.selection.picked;
  const auto xray = probe.xray();
  const auto ends = edge_positions(s, picked);
  const double delta = s.criteria.unit();
  std::string note = xray ? std::string(kind_text(xray->attempt.kind)) : std::string("an edge of Z");
  if (ends) note += ", " + short_number(distance((*ends)[0], (*ends)[1]) / delta) + " δ long";
  if (xray && xray->before) note += ", before the operation";
  widgets::heading(ui, icon::bolt, "Edge " + edge_text(picked.id, picked.other), note);
  for (const std::uint32_t end : {picked.id, picked.other}) {
    const bool alive = end < s.complex.vertices.size() && s.complex.vertices[end].alive;
    if (widgets::link_row(ui, "vertex", alive ? "vertex" : "vertex, gone", grouped(end),
                          "Selects the vertex.", end))
      ui.commands.post("pick", {"vertex", std::to_string(end)});
  }
  const auto event = m.selected_event();
  if (xray) verdict(ui, *xray);
  // What is tried comes first: it is what changes.
  const bool tried = m.selection.what_if.has_value();
  if (xray && tried) what_if(ui, probe, *xray);
  if (event) {
    ImGui::Dummy({0, ui.px(2)});
    widgets::quiet_text(ui, "The journal's decision");
    event_details(ui, *m.run.journal, *event);
  }
  // Which points lie outside of the kernel is the answer where that is why the edge stays.
  const bool outside = xray && xray->attempt.rejected == Reason::no_candidate;
  if (outside) outside_kernel(ui, *xray);
  if (xray) {
    standing(ui, *xray);
    ladder(ui, *xray);
    offenders(ui, xray->attempt.link);
    if (!tried) what_if(ui, probe, *xray);
    if (!outside) outside_kernel(ui, *xray);
    candidates(ui, *xray);
    search_regions(ui, *xray);
    kernel(ui, *xray);
    cost(ui, *xray, probe.study().get());
    unlock(ui, probe);
  } else if (probe.looking()) {
    widgets::quiet_text(ui, "The edge is being looked at.");
  } else if (s.complex.form == ZeroForm::free) {
    const std::size_t facets = facets_at(s.zero_set, VertexId(picked.id), VertexId(picked.other));
    if (facets > 0) widgets::value_row(ui, "stratum", facets == 1 ? "on the border of Z" : "in a sheet");
    widgets::quiet_text(
        ui, "Z is outside of T: there is no kernel to look into. The journal tells what was tried.", true);
  } else {
    widgets::quiet_text(ui, "T has no such edge at this step.", true);
  }
  if (m.run.journal) edge_history(ui, *m.run.journal, VertexId(picked.id), VertexId(picked.other));
}

} // namespace isoscope::panels
