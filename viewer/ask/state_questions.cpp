// Questions about the whole state: what violates conditions, the topology of Z, whether everything holds.
#include "ask/investigation.h"

#include "model/words.h"
#include "ui/answer.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>

namespace isoscope::panels {
namespace {

void title(const Ui& ui, const char* text) {
  ImGui::Dummy({0, ui.px(6)});
  widgets::bold_text(ui, text);
}

void violations(Ui& ui, const Investigation& asked, const StateSnapshot& s) {
  if (s.complex.form != ZeroForm::interpolated || !s.classifies()) return;
  title(ui, "Violating now");
  const std::size_t flat = flat_tets(s, s.criteria.height_limit()).size();
  if (!s.orientation_judged)
    widgets::quiet_text(ui, "Condition 3 is judged when the play head rests.", true);
  else if (widgets::link_row(ui, "misoriented", "misoriented (condition 3)",
                             grouped(misoriented_tets(s).size()),
                             "Selects the next one. Key N, Shift+N for the one before."))
    ui.commands.post("next-violation", {"misoriented"});
  if (widgets::link_row(ui, "flat", "below 2σ/α (condition 2)", grouped(flat),
                        "Selects the next one, the flattest first. Key N, Shift+N for the one before."))
    ui.commands.post("next-violation", {"flat"});
  if (flat == 0 || asked.violations != ViolationKind::flat) return;
  // The flattest, by height.
  constexpr std::size_t most = 6;
  const auto tets = flat_tets(s, s.criteria.height_limit());
  const double delta = s.criteria.unit();
  for (std::size_t i = 0; i < std::min(most, tets.size()); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (widgets::link_row(ui, "tet", "   tetrahedron " + grouped(tets[i].tet.value),
                          short_number(tets[i].height / delta) + " δ", "Selects it."))
      ui.commands.post("pick", {"tet", std::to_string(tets[i].tet.value)});
    ImGui::PopID();
  }
}

/// One surface has a genus; more than χ = 2 takes several, spheres if there are no more than needed.
std::string surface_text(const BoundarySide& side) {
  if (const auto genus = side.genus()) return "genus " + std::to_string(*genus);
  return std::to_string(side.least_parts()) + " or more parts";
}

void component(Ui& ui, const ComponentReport& c, std::size_t index, double delta) {
  const auto& n = c.counts;
  ImGui::PushFont(ui.fonts.small);
  widgets::verdict_glyph(ui, c.as_expected());
  ImGui::SameLine();
  ImGui::Text("component %zu: genus %ld", index, n.genus());
  ImGui::PopFont();
  widgets::value_row(ui, "V − E + F",
                     grouped(n.vertices) + " − " + grouped(n.edges) + " + " + grouped(n.polygons) + " = " +
                         std::to_string(n.euler_characteristic()));
  constexpr std::size_t most = 4;
  for (std::size_t k = 0; k < std::min(most, c.sides.size()); ++k)
    widgets::value_row(ui, side_text(c.sides[k].label) + " boundary " + std::to_string(c.sides[k].boundary),
                       "χ " + std::to_string(c.sides[k].euler_characteristic) + ", " +
                           surface_text(c.sides[k]));
  if (c.sides.size() > most) widgets::quiet_text(ui, "and " + grouped(c.sides.size() - most) + " more");
  if (c.loop) widgets::value_row(ui, "shortest handle loop", short_number(c.loop->length / delta) + " δ");
}

void topology(Ui& ui, Investigation& asked, const StateSnapshot& s) {
  const widgets::AnswerRegion region(ui, AnswerKind::topology, asked.topology_shown && asked.topology());
  title(ui, "Topology of Z");
  if (!asked.topology_shown) {
    if (widgets::plain_button(ui, "Judge each component", true, 0, ui.px(26))) ui.commands.post("topology");
    widgets::tip(ui, "Topology of Z",
                 "Each component against the boundaries of Ω beside it, with a shortest handle loop. Key T.");
    return;
  }
  const auto report = asked.topology();
  if (!report) return widgets::quiet_text(ui, "being judged …");
  widgets::quiet_text(ui, report->words, true);
  const double delta = s.criteria.unit();
  constexpr std::size_t most = 8;
  for (std::size_t c = 0; c < std::min(most, report->components.size()); ++c)
    component(ui, report->components[c], c, delta);
  if (report->components.size() > most)
    widgets::quiet_text(ui, "and " + grouped(report->components.size() - most) + " more components");
  if (widgets::plain_button(ui, "Hide", true, 0, ui.px(24))) ui.commands.post("topology");
}

struct InvariantText {
  const char *title, *help;
};
constexpr std::array<InvariantText, invariant_count> invariant_texts{
    {{"tetrahedra of T", "Positively oriented, neighbours agree, one shell outside. Exact."},
     {"Delaunay", "Each circumscribed ball is empty of the neighbours' vertices, while T is refined. Exact."},
     {"samples in tetrahedra", "Each in exactly one, found anew by a walk. Exact."},
     {"classes of samples", "ε computed anew is the one shown."},
     {"Z is a 2-manifold",
      "Every edge has two facets, or one on the border of an open surface; every vertex one fan."},
     {"Z is oriented", "Neighbours agree on which side is outside."},
     {"Z is free of self-intersections", "By exact predicates."},
     {"Z is inside Ω", "Every facet is proven nearer than δ. Due once the refinement is over."},
     {"Z separates the sides",
      "The winding number is right in every region. Due once the refinement is over."},
     {"topology as expected", "Components and χ. Due once the refinement is over."}}};

void invariant_row(Ui& ui, std::size_t i, const InvariantVerdict& v) {
  using State = InvariantVerdict::State;
  ImGui::PushID(static_cast<int>(i));
  ImGui::PushFont(ui.fonts.small);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (v.state == State::holds || v.state == State::broken)
    widgets::verdict_glyph(ui, v.state == State::holds);
  else
    widgets::glyph(ui, {at.x + ui.px(7), at.y + ui.fonts.small->FontSize / 2}, 4, ui.colors.quiet,
                   MarkerShape::circle);
  ImGui::SetCursorScreenPos({at.x + ui.px(20), at.y});
  std::string text = invariant_texts.at(i).title;
  if (v.state == State::not_due) text += ": not yet due";
  if (v.state == State::absent) text += ": nothing to ask";
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
  widgets::tip(ui, invariant_texts.at(i).title, invariant_texts.at(i).help);
  if (v.state == State::broken && !v.words.empty()) widgets::quiet_text(ui, v.words, true);
  ImGui::PopID();
}

void validity(Ui& ui, Investigation& i, const StateSnapshot& s) {
  const widgets::AnswerRegion region(ui, AnswerKind::check, !i.checking() && i.check() != nullptr);
  title(ui, "Is everything valid?");
  if (i.checking()) {
    const double done = i.check_fraction();
    widgets::quiet_text(ui, done >= 0 ? "checking … " + std::to_string(static_cast<int>(100 * done)) + " %"
                                      : "checking …");
    if (widgets::plain_button(ui, "Stop", true, 0, ui.px(24))) i.stop_check();
    return;
  }
  if (widgets::plain_button(ui, "Check everything", true, 0, ui.px(26))) ui.commands.post("check");
  widgets::tip(ui, "Check everything", "Judges the step shown from scratch. Key K.");
  widgets::beside_or_below(ui, "First invalid step");
  if (widgets::plain_button(ui, "First invalid step", true, 0, ui.px(26))) ui.commands.post("find-invalid");
  widgets::tip(ui, "First invalid step",
               "Where the step shown is not valid: bisection over the journal. Key Shift+K.");
  const auto answer = i.check();
  if (!answer) return;
  if (answer->report.step != s.step) widgets::quiet_text(ui, "step " + grouped(answer->report.step) + ":");
  for (std::size_t k = 0; k < invariant_count; ++k) invariant_row(ui, k, answer->report.verdicts[k]);
  if (!answer->first) return;
  if (answer->first->end == FirstInvalid::End::found) {
    const std::string step = grouped(answer->first->report.step);
    if (widgets::link_row(ui, "first", "first invalid step", step,
                          "Judged " + grouped(answer->first->probes) + " states. Goes there."))
      ui.commands.post("seek", {std::to_string(answer->first->report.step)});
  } else {
    widgets::quiet_text(ui, "This step is valid: there is nothing to look for before it.", true);
  }
}

} // namespace

void state_questions(Ui& ui, Investigation& asked, const StateSnapshot& s) {
  violations(ui, asked, s);
  topology(ui, asked, s);
  validity(ui, asked, s);
  ImGui::Dummy({0, ui.px(6)});
}

} // namespace isoscope::panels
