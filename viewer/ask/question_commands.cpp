// Commands that ask about the selected element, the work done, the topology and the validity of a step.
#include "command/command_groups.h"
#include "ui/icons.h"
#include "command/usage.h"

#include <algorithm>

namespace isoscope {
namespace {

using M = AppModel;
using A = Arguments;

bool has_state(const M& m) {
  return m.state() != nullptr;
}

void open_tab(M& m, int tab) {
  m.settings.panes.tab = tab;
  m.settings.panes.show_bottom = true;
}

Status next_violation(M& m, const A& a, int direction) {
  if (!a.empty()) {
    if (a[0] != "misoriented" && a[0] != "flat") return usage("The kinds are misoriented and flat.");
    m.investigation.violations = a[0] == "flat" ? ViolationKind::flat : ViolationKind::misoriented;
  }
  const auto state = m.state();
  if (m.investigation.violations == ViolationKind::misoriented && !state->orientation_judged)
    return usage("Condition 3 is judged when the play head rests.");
  const auto tets = violating_tets(*state, m.investigation.violations);
  if (tets.empty()) return usage("No tetrahedron violates this condition at this step.");
  const Pick& picked = m.selection.picked;
  const auto at =
      picked.kind == Pick::Kind::tet ? std::find(tets.begin(), tets.end(), TetId(picked.id)) : tets.end();
  const auto count = static_cast<std::ptrdiff_t>(tets.size());
  std::ptrdiff_t to = direction > 0 ? 0 : count - 1;
  if (at != tets.end()) to = (at - tets.begin() + direction + count) % count;
  const TetId t = tets[static_cast<std::size_t>(to)];
  const auto p = state->complex.positions(t);
  Pick pick;
  pick.kind = Pick::Kind::tet;
  pick.id = t.value;
  pick.point = 0.25 * (p[0] + p[1] + p[2] + p[3]);
  m.selection.pick(pick);
  m.requests.frame_selection = true;
  return {};
}

Status show_history(M& m, const A&) {
  if (!selected_element(m)) return usage("Select a vertex, an edge, a tetrahedron or a sample first.");
  open_tab(m, history_tab);
  return {};
}

Status last_change(M& m, const A&) {
  if (!selected_element(m)) return usage("Select a vertex, an edge, a tetrahedron or a sample first.");
  m.investigation.want_last_change();
  return {};
}

Status toggle_topology(M& m, const A&) {
  bool& shown = m.investigation.topology_shown;
  shown = !shown;
  if (shown) m.settings.panes.show_right = m.investigation.reveal_topology = true;
  return {};
}

Status check(M& m, bool search) {
  m.settings.panes.show_right = true;
  m.investigation.ask_check(m, search);
  return {};
}

/// The places of the input that the finished mesh leaves behind.
Status look_at_uncovered(M& m, std::size_t index) {
  if (!m.run.result || m.run.result->certificate.uncovered.empty())
    return usage("The finished mesh leaves nothing of the input behind.");
  const auto& places = m.run.result->certificate.uncovered;
  if (index >= places.size()) return usage("There are only " + std::to_string(places.size()) + " places.");
  const UncoveredPlace& p = places[index];
  m.selection.pick({});
  m.selection.mark = p.point;
  m.camera.frame(Box3{p.point, p.point}.grown(std::max(0.5 * p.size, p.distance)), !m.scripted);
  return {};
}

Status look_at(M& m, const A& a) {
  std::size_t index = 0;
  const bool stall = !a.empty() && a[0] == "stall";
  if (!a.empty()) {
    const std::string& last = a.back();
    if (last.find_first_not_of("0123456789") == std::string::npos && last.size() < 9)
      index = static_cast<std::size_t>(std::stoul(last));
  }
  if (!a.empty() && a[0] == "uncovered") return look_at_uncovered(m, index);
  const auto work = m.investigation.work();
  if (!work) return usage("The places are listed under Work.");
  const auto& cells = stall ? work->stall.places.cells : work->map.cells;
  if (index >= cells.size()) return usage("There are only " + std::to_string(cells.size()) + " places.");
  m.camera.frame(Box3{cells[index].center, cells[index].center}.grown(2 * work->map.cell_size), !m.scripted);
  m.selection.mark = cells[index].center;
  return {};
}

} // namespace

std::vector<Command> question_commands() {
  return {
      {"next-violation",
       "Next violating tetrahedron",
       "[misoriented | flat]",
       "Selects the next tetrahedron that violates condition 3, or the next flattest below 2σ/α.",
       "Ask",
       icon::cube,
       {{'N'}},
       [](M& m, const A& a) { return next_violation(m, a, 1); },
       has_state},
      {"previous-violation",
       "Previous violating tetrahedron",
       "[misoriented | flat]",
       "The one before it.",
       "Ask",
       nullptr,
       {{'N', false, true}},
       [](M& m, const A& a) { return next_violation(m, a, -1); },
       has_state},
      {"history",
       "History of the selection",
       "",
       "Lists what happened to the selected element over all steps and draws a vertex' way through "
       "collapses.",
       "Ask",
       icon::history,
       {{'H'}},
       show_history,
       has_state},
      {"last-change",
       "Last change of the selection",
       "",
       "Goes to the step before this one at which the selected element changed; again for earlier.",
       "Ask",
       nullptr,
       {{'L'}},
       last_change,
       has_state},
      {"advice",
       "Would other parameters help?",
       "",
       "Also asks the evaluator of selected edges over values of α and shrink.",
       "Ask",
       icon::sliders,
       {{'Y'}},
       [](M& m, const A&) {
         m.investigation.edge_advice = !m.investigation.edge_advice;
         return Status();
       },
       has_state,
       [](const M& m) { return m.investigation.edge_advice; }},
      {"topology",
       "Topology of Z",
       "",
       "Judges each component of Z against the boundaries of Ω and draws a shortest handle loop.",
       "Ask",
       nullptr,
       {{'T'}},
       toggle_topology,
       has_state,
       [](const M& m) { return m.investigation.topology_shown; }},
      {"check",
       "Check everything at this step",
       "",
       "Judges from scratch all that must hold at the step shown.",
       "Ask",
       icon::check,
       {{'K'}},
       [](M& m, const A&) { return check(m, false); },
       has_state},
      {"find-invalid",
       "Find the first invalid step",
       "",
       "Where the step shown is not valid: bisection over the journal for the first that is not.",
       "Ask",
       nullptr,
       {{'K', false, true}},
       [](M& m, const A&) { return check(m, true); },
       has_state},
      {"work",
       "Where the work goes",
       "",
       "Draws insertions or attempts as a heat map; tells time by reason and why nothing is accepted.",
       "Ask",
       icon::chart,
       {{'W', false, true}},
       [](M& m, const A&) {
         open_tab(m, work_tab);
         return Status();
       },
       has_state},
      {"look-at-place",
       "Look at a busy or uncovered place",
       "[work | stall | uncovered] [N]",
       "Moves the camera to the busiest places of the heat map or of the last attempts, or to those of the "
       "input that the finished mesh leaves behind, and marks it; 0 is the first.",
       "",
       nullptr,
       {},
       look_at,
       has_state},
  };
}

} // namespace isoscope
