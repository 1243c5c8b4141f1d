// Commands on two runs: beginning the second one, going to where they differ, linking their views.
#include "two_runs/comparison.h"

#include "command/commands.h"
#include "ui/icons.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace isoscope {
namespace {

/// The event from a difference on that shows what was decided: an operation, a refusal or an exhausted
/// tetrahedron; null where the journal ends before.
std::optional<std::uint32_t> telling_event(const Journal& journal, std::uint32_t from) {
  for (std::size_t i = from, n = journal.events().size(); i < n; ++i) {
    const Event& e = journal.events()[i];
    if (e.operation || e.kind == EventKind::rejection || e.kind == EventKind::exhausted)
      return static_cast<std::uint32_t>(i);
  }
  return std::nullopt;
}

/// Both play heads go to their events, or to the step that belongs to the other one's; both views show what
/// is named there.
void show_events(Comparison& m, const RunComparison& found, std::optional<std::uint32_t> a,
                 std::optional<std::uint32_t> b) {
  const bool active_is_b = m.active_is_b();
  const auto here = active_is_b ? b : a, there = active_is_b ? a : b;
  ShownRun& other = *m.other();
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
    m.debug.show_event(*here);
    if (!there) step_there = aligned(m.window.transport.step(), active_is_b);
  } else {
    m.window.transport.jump(there ? aligned(step_there, !active_is_b) : m.window.live_step());
    m.window.selection.pick({});
  }
  other.transport.jump(step_there);
  m.set_beside(true);
  m.keep_steps();
  m.picked = picked;
}

Result<std::shared_ptr<const RunComparison>> comparison_of(const Comparison& m) {
  const auto found = m.found();
  if (!found) return usage("The runs are still being compared.");
  return found;
}

Status first_difference(Comparison& m, const Arguments&) {
  const auto found = comparison_of(m);
  if (!found) return found.error();
  m.window.open_tab(BottomTab::compare);
  m.row.reset();
  const auto& d = (*found)->decision ? (*found)->decision : (*found)->measure;
  if (!d) {
    m.window.tell((*found)->same_samples ? "The runs do not differ." : "Only their samples differ.");
    return {};
  }
  show_events(m, **found, telling_event(*m.run(false)->run.journal, d->event),
              telling_event(*m.run(true)->run.journal, d->event));
  return {};
}

Status show_row(Comparison& m, std::size_t row) {
  const auto found = comparison_of(m);
  if (!found) return found.error();
  const auto& rows = (*found)->decisions.rows;
  if (row >= rows.size()) return usage("There are " + std::to_string(rows.size()) + " such decisions.");
  m.window.open_tab(BottomTab::compare);
  const DecisionDifference& d = rows[row];
  const std::optional<std::uint32_t> made = d.event;
  show_events(m, **found, d.made_by_a ? made : d.refusal, d.made_by_a ? d.refusal : made);
  // Where the other run never spoke of the edge, the camera goes by the place.
  if (d.made_by_a == m.active_is_b() && !d.refusal)
    m.window.camera.frame(Box3{d.place, d.place}.grown(3 * m.window.run.scene->delta), !m.window.scripted);
  m.row = row;
  return {};
}

Status go_to_difference(Comparison& m, const Arguments& a) {
  const auto row = whole_argument(a, 0, 0, 99999999);
  if (!row || a.size() != 1) return usage("Which row of the table? 0 is the first.");
  return show_row(m, *row);
}

Status next_difference(Comparison& m, int direction) {
  const auto found = comparison_of(m);
  if (!found) return found.error();
  const auto count = static_cast<std::ptrdiff_t>((*found)->decisions.rows.size());
  if (count == 0) return usage("No decision was made by one run alone.");
  const auto& row = m.row;
  std::ptrdiff_t to = direction > 0 ? 0 : count - 1;
  if (row) to = (static_cast<std::ptrdiff_t>(*row) + direction + count) % count;
  return show_row(m, static_cast<std::size_t>(to));
}

Status open_beside_or_ask(Comparison& m, const Arguments& a) {
  if (a.size() > 1) return usage("One model or recording opens beside the run.");
  if (!a.empty()) return m.open_beside(a[0]);
  m.window.files_for = FilesFor::beside;
  m.window.toggle(Overlay::files);
  return {};
}

Status side_by_side(Comparison& m, const Arguments&) {
  const bool beside = !m.beside();
  m.set_beside(beside);
  if (beside) m.window.open_tab(BottomTab::compare);
  return {};
}

Status toggle_linked_cameras(Comparison& m, const Arguments&) {
  m.linked_cameras = !m.linked_cameras;
  if (!m.linked_cameras) m.camera = m.window.camera;
  return {};
}

Status toggle_linked_steps(Comparison& m, const Arguments&) {
  m.linked_steps = !m.linked_steps;
  if (m.linked_steps) m.set_beside(m.beside()); // linked anew
  return {};
}

} // namespace

void Comparison::add_commands(CommandTable& table) {
  const auto has_scene = [this] { return window.run.scene != nullptr; };
  const auto has_other = [this] { return other() != nullptr; };
  add_group(table, {.menu = "Run", .enabled = has_other},
            {{.name = "run-beside",
              .title = "Run beside",
              .help = "Runs the same input with the panel's parameters beside this run: two views, A and B.",
              .icon = icon::split,
              .keys = {{GLFW_KEY_ENTER, true, true}},
              .run = [this](const Arguments&) { return run_beside(); },
              .enabled = has_scene},
             {.name = "open-beside",
              .title = "Open beside…",
              .usage = "[FILE | gallery:NAME]",
              .help = "Opens a recording or a model beside this run; without a name it shows the files.",
              .icon = icon::folder_open,
              .keys = {{'O', true, true}},
              .run = on(*this, open_beside_or_ask),
              .enabled = has_scene},
             {.name = "side-by-side",
              .title = "Two views",
              .help = "Draws the other run beside this one, also the one that a branch left, or hides it.",
              .icon = icon::split,
              .keys = {{'B'}},
              .run = on(*this, side_by_side),
              .checked = [this] { return beside(); }},
             {.name = "both-z",
              .title = "Both Z in one view",
              .help = "Draws the edges of the other run's Z over this one's.",
              .keys = {{'B', false, true}},
              .run = flips(window.view.other_zero.visible),
              .checked = is_on(window.view.other_zero.visible)},
             {.name = "other-run",
              .title = "Change to the other run",
              .help = "Makes the other run the active one: panels, keys and questions speak of it.",
              .icon = icon::flip,
              .keys = {{GLFW_KEY_TAB}},
              .run = [this](const Arguments&) { return change_run(); }},
             {.name = "first-difference",
              .title = "First differing decision",
              .help = "Takes both play heads to the first event that the runs decided differently.",
              .icon = icon::target,
              .keys = {{'D'}},
              .run = on(*this, first_difference)},
             {.name = "next-difference",
              .title = "Next differing decision",
              .help = "Takes both play heads to the next decision of the table that only one run made.",
              .keys = {{'G'}},
              .run = [this](const Arguments&) { return next_difference(*this, 1); }},
             {.name = "previous-difference",
              .title = "Previous differing decision",
              .help = "The one before it.",
              .keys = {{'G', false, true}},
              .run = [this](const Arguments&) { return next_difference(*this, -1); }}});
  table.add({{.name = "difference",
              .title = "Go to a differing decision…",
              .usage = "ROW",
              .help = "Shows a row of the table of decisions that only one run made; 0 is the first.",
              .run = on(*this, go_to_difference),
              .enabled = has_other}});
  add_group(table, {.menu = "Run", .enabled = has_other},
            {{.name = "link-cameras",
              .title = "Link the cameras",
              .help = "One camera for both views, or one each.",
              .run = on(*this, toggle_linked_cameras),
              .checked = is_on(linked_cameras)},
             {.name = "link-steps",
              .title = "Link the play heads",
              .help = "The other run goes along: by step up to the first difference, by stage after it. Or "
                      "each goes its own way.",
              .run = on(*this, toggle_linked_steps),
              .checked = is_on(linked_steps)},
             {.name = "close-other",
              .title = "Close the other run",
              .help = "Ends the run that is not active and gives its half back.",
              .icon = icon::close,
              .run = does([this] { close_other(); })}});
}

void Comparison::add_branch_command(CommandTable& table) {
  table.add(
      {{.name = "do-it",
        .title = "Do it: branch the run",
        .help =
            "Collapses the edge to the target that is tried in a run of its own that goes on from this step.",
        .menu = "Select",
        .icon = icon::check,
        .keys = {{'D', true}},
        .run = [this](const Arguments&) { return branch_here(); },
        .enabled =
            [this] {
              const auto study = debug.probe.study();
              return study && study->attempt.possible();
            }}});
}

} // namespace isoscope
