// Commands that ask about the selected element, the work done, the topology and the validity of a step.
#include "ask/investigation.h"

#include "command/commands.h"
#include "ui/icons.h"

#include <algorithm>

namespace isoscope {
namespace {

Status next_violation(Investigation& m, const Arguments& a, int direction) {
  if (!a.empty()) {
    if (a[0] != "misoriented" && a[0] != "flat") return usage("The kinds are misoriented and flat.");
    m.violations = a[0] == "flat" ? ViolationKind::flat : ViolationKind::misoriented;
  }
  const auto state = m.window.state();
  if (!state->classifies())
    return usage("Nothing is judged here: there is no T that carries Z at this step.");
  if (m.violations == ViolationKind::misoriented && !state->orientation_judged)
    return usage("Condition 3 is judged when the play head rests.");
  const auto tets = violating_tets(*state, m.violations);
  if (tets.empty()) return usage("No tetrahedron violates this condition at this step.");
  const Pick& picked = m.window.selection.picked;
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
  m.window.selection.pick(pick);
  m.window.requests.frame_selection = true;
  return {};
}

Status show_history(Investigation& m, const Arguments&) {
  if (!selected_element(m.window.selection))
    return usage("Select a vertex, an edge, a tetrahedron or a sample first.");
  m.window.open_tab(BottomTab::history);
  return {};
}

Status last_change(Investigation& m, const Arguments&) {
  if (!selected_element(m.window.selection))
    return usage("Select a vertex, an edge, a tetrahedron or a sample first.");
  m.want_last_change();
  return {};
}

Status toggle_topology(Investigation& m, const Arguments&) {
  bool& shown = m.topology_shown;
  shown = !shown;
  if (shown) m.window.bring_into_sight(AnswerKind::topology);
  return {};
}

Status show_certificate(Investigation& m, const Arguments&) {
  m.window.transport.follow();
  m.window.bring_into_sight(AnswerKind::certificate);
  return {};
}

Status check_step(Investigation& m, bool search) {
  m.window.bring_into_sight(AnswerKind::check);
  m.ask_check(search);
  return {};
}

/// The places of the input that the finished mesh leaves behind.
Status look_at_uncovered(Investigation& m, std::size_t index) {
  if (!m.window.run.result || m.window.run.result->certificate.uncovered.empty())
    return usage("The finished mesh leaves nothing of the input behind.");
  const auto& places = m.window.run.result->certificate.uncovered;
  if (index >= places.size()) return usage("There are only " + std::to_string(places.size()) + " places.");
  const UncoveredPlace& p = places[index];
  m.window.selection.pick({});
  m.window.selection.mark = p.point;
  m.window.camera.frame(Box3{p.point, p.point}.grown(std::max(0.5 * p.size, p.distance)), !m.window.scripted);
  return {};
}

/// Goes to a place and marks it.
Status look_there(Investigation& m, Vec3 place, double reach) {
  m.window.selection.pick({});
  m.window.selection.mark = place;
  m.window.camera.frame(Box3{place, place}.grown(reach), !m.window.scripted);
  m.window.camera.mark_set();
  return {};
}

/// What the study of δ and the choice of points name.
Status look_at_field(Investigation& m, const std::string& what, std::size_t index) {
  const auto& scene = m.window.run.scene;
  if (what == "dropped") {
    if (!scene || !scene->points || index >= scene->points->dropped.size())
      return usage("No points were dropped there.");
    const DroppedPoints& d = scene->points->dropped[index];
    return look_there(m, d.place, std::max(8 * scene->delta, d.why == DroppedPoints::Why::blob ? d.size : 0));
  }
  if (!scene || !scene->study || !scene->study->found())
    return usage("No tolerance was found at which Ω encloses something.");
  return look_there(m, what == "opening" ? scene->study->saddle() : scene->study->closing(),
                    12 * scene->delta);
}

Status look_at(Investigation& m, const Arguments& a) {
  const bool stall = !a.empty() && a[0] == "stall";
  const std::size_t index = a.empty() ? 0 : whole_argument(a, a.size() - 1, 0, 99999999).value_or(0);
  if (!a.empty() && a[0] == "uncovered") return look_at_uncovered(m, index);
  if (!a.empty() && (a[0] == "opening" || a[0] == "closing" || a[0] == "dropped"))
    return look_at_field(m, a[0], index);
  const auto work = m.work();
  if (!work) return usage("The places are listed under Work.");
  const auto& cells = stall ? work->stall.places.cells : work->map.cells;
  if (index >= cells.size()) return usage("There are only " + std::to_string(cells.size()) + " places.");
  m.window.camera.frame(Box3{cells[index].center, cells[index].center}.grown(2 * work->map.cell_size),
                        !m.window.scripted);
  m.window.selection.mark = cells[index].center;
  return {};
}

} // namespace

void Investigation::add_commands(CommandTable& table) {
  const auto has_state = [this] { return window.has_state(); };
  add_group(
      table, {.menu = "Ask", .enabled = has_state},
      {{.name = "next-violation",
        .title = "Next violating tetrahedron",
        .usage = "[misoriented | flat]",
        .help = "Selects the next tetrahedron that violates condition 3, or the next flattest below 2σ/α.",
        .icon = icon::cube,
        .keys = {{'N'}},
        .run = [this](const Arguments& a) { return next_violation(*this, a, 1); }},
       {.name = "previous-violation",
        .title = "Previous violating tetrahedron",
        .usage = "[misoriented | flat]",
        .help = "The one before it.",
        .keys = {{'N', false, true}},
        .run = [this](const Arguments& a) { return next_violation(*this, a, -1); }},
       {.name = "history",
        .title = "History of the selection",
        .help = "Lists what happened to the selected element over all steps and draws a vertex' way through "
                "collapses.",
        .icon = icon::history,
        .keys = {{'H'}},
        .run = on(*this, show_history)},
       {.name = "last-change",
        .title = "Last change of the selection",
        .help = "Goes to the step before this one at which the selected element changed; again for earlier.",
        .keys = {{'L'}},
        .run = on(*this, last_change)},
       {.name = "advice",
        .title = "Would other parameters help?",
        .help = "Also asks the evaluator of selected edges over values of α and shrink.",
        .icon = icon::sliders,
        .keys = {{'Y'}},
        .run = does([this] {
          edge_advice = !edge_advice;
          if (edge_advice) window.bring_into_sight(AnswerKind::advice);
        }),
        .checked = is_on(edge_advice)}});
  add_group(
      table, {.menu = "Ask", .enabled = has_state},
      {{.name = "topology",
        .title = "Topology of Z",
        .help = "Judges each component of Z against the boundaries of Ω and draws a shortest handle loop.",
        .keys = {{'T'}},
        .run = on(*this, toggle_topology),
        .checked = is_on(topology_shown)},
       {.name = "certificate",
        .title = "Certificate of the result",
        .help = "Goes to the end of the finished run and shows what is proven of its mesh.",
        .run = on(*this, show_certificate),
        .enabled = [this] { return window.run.result != nullptr; }},
       {.name = "check",
        .title = "Check everything at this step",
        .help = "Judges from scratch all that must hold at the step shown.",
        .icon = icon::check,
        .keys = {{'K'}},
        .run = [this](const Arguments&) { return check_step(*this, false); }},
       {.name = "find-invalid",
        .title = "Find the first invalid step",
        .help = "Where the step shown is not valid: bisection over the journal for the first that is not.",
        .keys = {{'K', false, true}},
        .run = [this](const Arguments&) { return check_step(*this, true); }}});
  add_group(
      table, {.menu = "Ask", .enabled = has_state},
      {{.name = "work",
        .title = "Where the work goes",
        .help =
            "Draws insertions or attempts as a heat map; tells time by reason and why nothing is accepted.",
        .icon = icon::chart,
        .keys = {{'W', false, true}},
        .run = does([this] { window.open_tab(BottomTab::work); })}});
  table.add(
      {{.name = "look-at-place",
        .title = "Look at a busy or uncovered place",
        .usage = "[work | stall | uncovered | dropped] [N] | opening | closing",
        .help =
            "Moves the camera to the busiest places of the heat map or of the last attempts, or to those "
            "of the input that the finished mesh leaves behind or of points that were dropped, or to where "
            "the inside opens or closes first as δ changes, and marks it; 0 is the first.",
        .run = on(*this, look_at),
        .enabled = has_state}});
  add_rim_commands(table);
}

} // namespace isoscope
