// What the inspector adds under an element: remedies and parameters that would help.
#include "ask/investigation.h"

#include "model/words.h"
#include "ui/answer.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>

namespace isoscope::panels {
namespace {

void pick_sample(Ui& ui, SampleId s) {
  ui.commands.post("pick", {"sample", std::to_string(s.value)});
}

const char* parameter_title(ParameterAdvice::Parameter parameter) {
  constexpr std::array<const char*, 3> titles{"α", "σ/δ", "shrink"};
  return titles.at(static_cast<std::size_t>(parameter));
}

void advice_row(const Ui& ui, const ParameterAdvice& a, double delta) {
  const double unit = a.parameter == ParameterAdvice::Parameter::sigma ? delta : 1;
  const std::string label =
      std::string(parameter_title(a.parameter)) + " for condition " + std::string(words(a.condition).title);
  std::string value;
  if (a.holds)
    value = "holds with " + short_number(a.now / unit);
  else if (a.works)
    value = std::string(a.at_least ? "from " : "up to ") + short_number(*a.works / unit) + ", now " +
            short_number(a.now / unit);
  else
    value = "no value helps";
  widgets::value_row(ui, label, value,
                     a.holds   ? ui.colors.good_text
                     : a.works ? ui.colors.warning_text
                               : ui.colors.bad_text);
}

} // namespace

void tet_questions(Ui& ui, Investigation& asked, const StateSnapshot& s, std::uint32_t id) {
  if (s.complex.form != ZeroForm::interpolated) return;
  const auto index = ui.window.sample_index();
  const auto x = inspect_tet(s, TetId(id), asked.shrink.value_or(s.criteria.shrink),
                             index && index->set == s.samples ? &index->nearest : nullptr);
  if (!x) return;
  widgets::quiet_text(ui, "factor of the copy drawn");
  auto factor = static_cast<float>(x->shrink);
  if (widgets::slider(ui, "##shrink", factor, 0.02f, 1.0f, "%.2f"))
    asked.shrink = static_cast<double>(factor);
  widgets::tip(
      ui, "Shrunk copy",
      "Condition 3 asks the samples nearest to the vertices of this copy: lines end in a disc where f "
      "has their side's sign, in a cross where not. Its own factor is a parameter of the run.");
  if (asked.shrink && x->orientation) {
    widgets::value_row(ui, "with this factor", x->orientation->misoriented ? "misoriented" : "holds",
                       x->orientation->misoriented ? ui.colors.bad_text : ui.colors.good_text);
    if (widgets::plain_button(ui, "condition 3's factor", true, 0, ui.px(24))) asked.shrink.reset();
  }
  if (x->candidate.valid()) {
    if (widgets::link_row(ui, "candidate", "nearest to the circumcentre",
                          "sample " + grouped(x->candidate.value),
                          "Conditions 2 and 3 insert it. Selects it."))
      pick_sample(ui, x->candidate);
    if (x->candidate_is_vertex)
      widgets::quiet_text(ui, "It is a vertex already: nothing is left to insert.", true);
  } else if (x->orientation) {
    widgets::quiet_text(ui, "No sample lies in its circumscribed ball: nothing is left to insert.", true);
  }
}

void sample_questions(Ui& ui, const StateSnapshot& s, std::uint32_t id) {
  const auto x = inspect_sample(s, SampleId(id));
  if (!x) return;
  using Remedy = SampleInspection::Remedy;
  std::string words;
  switch (x->remedy) {
  case Remedy::none_needed:
    words = "ε is within 1 − α: nothing is inserted for it.";
    break;
  case Remedy::not_asked:
    words = "Condition 1 is not asked any more; collapses keep its class.";
    break;
  case Remedy::itself_next:
    words = "It goes in next: no tetrahedron holds a worse sample.";
    break;
  case Remedy::itself_later:
    words = "It goes in itself, after the worst samples of " + grouped(x->tets_before) + " tetrahedra.";
    break;
  case Remedy::worse_in_tet:
    words = grouped(x->worse_in_tet) +
            " samples of its tetrahedron are worse: the worst goes in for it, after " +
            grouped(x->tets_before) + " other tetrahedra.";
    break;
  case Remedy::vertex_already:
    words = "It is a vertex of T already: inserting it changes nothing.";
    break;
  }
  widgets::quiet_text(ui, words, true);
  if (x->fixer.valid() && x->fixer.value != id &&
      widgets::link_row(ui, "fixer", "mended by sample", grouped(x->fixer.value),
                        "The diamond in the view. Selects it."))
    pick_sample(ui, x->fixer);
}

void advice(Ui& ui, const Investigation& asked) {
  const WindowState& m = ui.window;
  const bool edge = m.selection.picked.kind == Pick::Kind::edge;
  if (edge && !asked.edge_advice) {
    if (widgets::plain_button(ui, "Would other parameters help?", true, 0, ui.px(26)))
      ui.commands.post("advice");
    widgets::tip(ui, "Other parameters", "Asks the evaluator over values of α and shrink. Key Y.");
    return;
  }
  const auto found = asked.advice();
  const widgets::AnswerRegion region(ui, AnswerKind::advice, found != nullptr);
  if (!found) {
    if (edge) widgets::quiet_text(ui, "other parameters: being tried …");
    return;
  }
  if (found->empty()) {
    if (edge) widgets::quiet_text(ui, "No check of it depends on α, σ or shrink.", true);
    return;
  }
  ImGui::Dummy({0, ui.px(4)});
  widgets::bold_text(ui, "Would other parameters help here?");
  const double delta = m.run.scene && m.run.scene->delta > 0 ? m.run.scene->delta : 1;
  for (const ParameterAdvice& a : *found) advice_row(ui, a, delta);
}

void history_buttons(Ui& ui) {
  if (!selected_element(ui.window.selection)) return;
  const auto button = [&](const char* label, const char* command, const char* title, const char* text) {
    if (widgets::plain_button(ui, label, true, 0, ui.px(26))) ui.commands.post(command);
    widgets::tip(ui, title, text);
  };
  button("History", "history", "History", "All that happened to it, over all steps. Key H.");
  ImGui::SameLine(0, ui.px(6));
  button("Last change", "last-change", "Last change",
         "Goes to the last step before this one at which it changed; again for earlier. Key L.");
  ImGui::Dummy({0, ui.px(2)});
}

} // namespace isoscope::panels
