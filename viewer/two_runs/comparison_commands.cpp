// Commands on two runs: beginning the second one, going to where they differ, linking their views.
#include "command/command_groups.h"

#include "debug/debug_actions.h"
#include "ui/icons.h"
#include "command/usage.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace isoscope {
namespace {

using M = AppModel;
using A = Arguments;

bool has_other(const M& m) {
  return m.comparison.other() != nullptr;
}

void open_tab(M& m) {
  m.settings.panes.tab = comparison_tab;
  m.settings.panes.show_bottom = true;
}

/// Both play heads go to their events, or to the step that belongs to the other one's; both views show what
/// is named there.
void show_events(M& m, const RunComparison& found, std::optional<std::uint32_t> a,
                 std::optional<std::uint32_t> b) {
  const bool active_is_b = m.comparison.active_is_b();
  const auto here = active_is_b ? b : a, there = active_is_b ? a : b;
  ShownRun& other = *m.comparison.other();
  const auto aligned = [&](Step step, bool of_b) {
    return of_b ? found.alignment.to_a(step) : found.alignment.to_b(step);
  };
  Pick picked;
  Step step_there = other.live_step();
  if (there) {
    const Event& e = other.run.journal->events()[*there];
    step_there = step_showing(e);
    picked = pick_of(e);
  }
  if (here) {
    show_event(m, *here);
    if (!there) step_there = aligned(m.transport.step(), active_is_b);
  } else {
    m.transport.jump(there ? aligned(step_there, !active_is_b) : m.live_step());
    m.selection.pick({});
  }
  other.transport.jump(step_there);
  m.comparison.set_beside(true);
  m.comparison.keep_steps(m);
  m.comparison.picked = picked;
}

Result<std::shared_ptr<const RunComparison>> comparison_of(const M& m) {
  const auto found = m.comparison.found();
  if (!found) return usage("The runs are still being compared.");
  return found;
}

Status first_difference(M& m, const A&) {
  const auto found = comparison_of(m);
  if (!found) return found.error();
  open_tab(m);
  m.comparison.row.reset();
  const auto& d = (*found)->decision ? (*found)->decision : (*found)->measure;
  if (!d) {
    m.tell((*found)->same_samples ? "The runs do not differ." : "Only their samples differ.");
    return {};
  }
  show_events(m, **found, telling_event(*compared_run(m, false)->run.journal, d->event),
              telling_event(*compared_run(m, true)->run.journal, d->event));
  return {};
}

Status show_row(M& m, std::size_t row) {
  const auto found = comparison_of(m);
  if (!found) return found.error();
  const auto& rows = (*found)->decisions.rows;
  if (row >= rows.size()) return usage("There are " + std::to_string(rows.size()) + " such decisions.");
  open_tab(m);
  const DecisionDifference& d = rows[row];
  const std::optional<std::uint32_t> made = d.event;
  show_events(m, **found, d.made_by_a ? made : d.refusal, d.made_by_a ? d.refusal : made);
  // Where the other run never spoke of the edge, the camera goes by the place.
  if (d.made_by_a == m.comparison.active_is_b() && !d.refusal)
    m.camera.frame(Box3{d.place, d.place}.grown(3 * m.run.scene->delta), !m.scripted);
  m.comparison.row = row;
  return {};
}

Status go_to_difference(M& m, const A& a) {
  if (a.size() != 1 || a[0].empty() || a[0].size() > 8 ||
      a[0].find_first_not_of("0123456789") != std::string::npos)
    return usage("Which row of the table? 0 is the first.");
  return show_row(m, static_cast<std::size_t>(std::stoul(a[0])));
}

Status next_difference(M& m, int direction) {
  const auto found = comparison_of(m);
  if (!found) return found.error();
  const auto count = static_cast<std::ptrdiff_t>((*found)->decisions.rows.size());
  if (count == 0) return usage("No decision was made by one run alone.");
  const auto& row = m.comparison.row;
  std::ptrdiff_t to = direction > 0 ? 0 : count - 1;
  if (row) to = (static_cast<std::ptrdiff_t>(*row) + direction + count) % count;
  return show_row(m, static_cast<std::size_t>(to));
}

Status open_beside(M& m, const A& a) {
  if (a.size() > 1) return usage("One model or recording opens beside the run.");
  if (!a.empty()) return m.open_beside(a[0]);
  m.files_beside = true;
  m.overlay = m.overlay == Overlay::files ? Overlay::none : Overlay::files;
  return {};
}

Status side_by_side(M& m, const A&) {
  const bool beside = !m.comparison.beside();
  m.comparison.set_beside(beside);
  if (beside) open_tab(m);
  return {};
}

Status link_cameras(M& m, const A&) {
  m.comparison.linked_cameras = !m.comparison.linked_cameras;
  if (!m.comparison.linked_cameras) m.comparison.camera = m.camera;
  return {};
}

Status link_steps(M& m, const A&) {
  m.comparison.linked_steps = !m.comparison.linked_steps;
  if (m.comparison.linked_steps) m.comparison.set_beside(m.comparison.beside()); // linked anew
  return {};
}

} // namespace

std::vector<Command> comparison_commands() {
  return {
      {"run-beside",
       "Run beside",
       "",
       "Runs the same input with the panel's parameters beside this run: two views, A and B.",
       "Run",
       icon::split,
       {{GLFW_KEY_ENTER, true, true}},
       [](M& m, const A&) { return m.run_beside(); },
       [](const M& m) { return m.run.scene != nullptr; }},
      {"open-beside",
       "Open beside…",
       "[FILE | gallery:NAME]",
       "Opens a recording or a model beside this run; without a name it shows the files.",
       "Run",
       icon::folder_open,
       {{'O', true, true}},
       open_beside,
       [](const M& m) { return m.run.scene != nullptr; }},
      {"side-by-side",
       "Two views",
       "",
       "Draws the other run beside this one, also the one that a branch left, or hides it.",
       "Run",
       icon::split,
       {{'B'}},
       side_by_side,
       has_other,
       [](const M& m) { return m.comparison.beside(); }},
      {"other-run",
       "Change to the other run",
       "",
       "Makes the other run the active one: panels, keys and questions speak of it.",
       "Run",
       icon::flip,
       {{GLFW_KEY_TAB}},
       [](M& m, const A&) { return m.change_run(); },
       has_other},
      {"first-difference",
       "First differing decision",
       "",
       "Takes both play heads to the first event that the runs decided differently.",
       "Run",
       icon::target,
       {{'D'}},
       first_difference,
       has_other},
      {"next-difference",
       "Next differing decision",
       "",
       "Takes both play heads to the next decision of the table that only one run made.",
       "Run",
       nullptr,
       {{'G'}},
       [](M& m, const A&) { return next_difference(m, 1); },
       has_other},
      {"previous-difference",
       "Previous differing decision",
       "",
       "The one before it.",
       "Run",
       nullptr,
       {{'G', false, true}},
       [](M& m, const A&) { return next_difference(m, -1); },
       has_other},
      {"difference",
       "Go to a differing decision…",
       "ROW",
       "Shows a row of the table of decisions that only one run made; 0 is the first.",
       "",
       nullptr,
       {},
       go_to_difference,
       has_other},
      {"link-cameras",
       "Link the cameras",
       "",
       "One camera for both views, or one each.",
       "Run",
       nullptr,
       {},
       link_cameras,
       has_other,
       [](const M& m) { return m.comparison.linked_cameras; }},
      {"link-steps",
       "Link the play heads",
       "",
       "The other run goes along: by step up to the first difference, by stage after it. Or each goes its "
       "own way.",
       "Run",
       nullptr,
       {},
       link_steps,
       has_other,
       [](const M& m) { return m.comparison.linked_steps; }},
      {"close-other",
       "Close the other run",
       "",
       "Ends the run that is not active and gives its half back.",
       "Run",
       icon::close,
       {},
       [](M& m, const A&) {
         m.close_other();
         return Status();
       },
       has_other},
  };
}

} // namespace isoscope
