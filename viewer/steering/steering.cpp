// What is asked of the session, and what the draft of the parameters would change.
#include "steering/steering.h"

#include "input/gallery.h"
#include "model/chosen_input.h"
#include "recording/copy_reader.h"

namespace isoscope {

Status Steering::open_tiles(const std::string& folder) {
  if (Status opened = tiles.open(folder); !opened) return opened;
  if (!window.scripted) window.settings.add_recent(folder);
  window.overlay = Overlay::none;
  window.draft = tiles.folder()->manifest().parameters; // a restart makes the same without tiles
  return {};
}

Status Steering::open(const std::string& input, bool paused, const std::string& inside) {
  const RunParameters before = window.draft;
  window.draft = for_input(window.draft, input);
  window.draft.inside = inside;
  Status begun = begin(paused);
  if (!begun) window.draft = before;
  return begun;
}

void Steering::follow(const std::string& copy) {
  window.draft = for_input(window.draft, copy);
  window.draft.inside.clear();
  if (Status begun = begin(false, true); !begun) window.report(begun.error());
}

void Steering::open_between(const std::string& one, const std::string& other, bool paused) {
  window.overlay = Overlay::none;
  walls_paused_ = paused;
  walls_.ask(one, other);
}

void Steering::take_walls() {
  const auto walls = walls_.take();
  if (!walls) return;
  const Status opened =
      *walls ? open((*walls)->outer, walls_paused_, (*walls)->inner) : Status(walls->error());
  if (!opened) window.report(opened.error());
}

Status Steering::begin(bool paused, bool follow) {
  const std::string input = window.draft.input;
  if (window.draft.inside.empty() && TileFolder::exists(input)) return open_tiles(input);
  tiles.show(false);
  if (!input.starts_with(gallery_prefix) && window.draft.inside.empty() && !window.scripted)
    window.settings.add_recent(input);
  window.overlay = Overlay::none;
  window.transport.restart();
  debug.breakpoints->forget_hits();
  if (is_recording_name(input) && (follow || lies_elsewhere(input)))
    window.session.follow_copy(input);
  else if (is_recording_name(input))
    window.session.open_recording(input);
  else
    window.session.start(window.draft, nullptr, paused);
  return {};
}

Status Steering::restart() {
  if (window.draft.input.empty()) return {};
  if (Status right = check_draft(window.draft); !right) return right;
  window.transport.restart();
  debug.breakpoints->forget_hits();
  tiles.show(false);
  // The input of a recording may be on another machine: the recording holds it.
  const bool stored =
      window.shows_recording() && window.run.scene && window.draft.input == window.run.parameters.input;
  if (stored)
    window.session.start(window.draft, window.run.scene->input, false, window.run.scene->notes);
  else
    window.session.start(window.draft);
  return {};
}

Status Steering::apply() {
  const ApplyPlan wanted = plan();
  if (wanted.error) return *wanted.error;
  if (wanted.way == ApplyWay::branch) return runs.branch_with_draft(wanted.step);
  if (wanted.way == ApplyWay::nothing) return {};
  if (Status fits = window.session.apply(window.draft); !fits) return fits;
  window.transport.follow();
  return {};
}

Status Steering::apply_earlier() {
  const ApplyPlan wanted = plan();
  if (wanted.way == ApplyWay::too_late && wanted.step_known) return runs.branch_with_draft(wanted.step);
  return wanted.error ? *wanted.error : usage("What was changed matters at the step shown: use apply.");
}

bool Steering::draft_differs() const {
  const double by_default = window.run.scene ? window.run.scene->default_sigma : 0.5;
  RunParameters wanted = window.draft, now = used_parameters(window);
  for (RunParameters* p : {&wanted, &now}) p->sigma = p->sigma_ratio(by_default);
  return fields_differ(wanted, now, [](const FieldFacts&) { return true; });
}

Status Steering::may_set(const std::string& parameter) const {
  if (parameter != "tolerance" || window.draft.inside.empty()) return {};
  return usage("δ is not given here: it is half of what the two surfaces are apart.");
}

void Steering::add_parameter_values(NamedValues& values) {
  for (const NamedField<RunParameters>& f : named_fields<RunParameters>())
    values.add(
        f.name, f.help, [this, get = f.get] { return get(window.draft); },
        [this, name = f.name, set = f.set](const std::string& text) {
          const Status may = may_set(name);
          return may ? set(window.draft, text) : may;
        });
}

CriteriaParameters Steering::draft_criteria() const {
  return window.run.scene ? window.draft.criteria(window.run.scene->delta, window.run.scene->default_sigma)
                          : window.draft.criteria(0);
}

std::shared_ptr<const ViolationPreview> Steering::draft_preview() const {
  const auto preview = window.playhead.preview();
  if (!preview || preview->state != window.state() || preview->criteria != draft_criteria()) return nullptr;
  return preview->violations;
}

void Steering::forget() {
  preview_asked_.reset();
  error_seen_.clear();
  draft_generation_ = 0;
}

void Steering::show_tile(const TileRerun& rerun) {
  if (const Status opened = open(rerun.file); !opened) window.report(opened.error());
  if (rerun.box.empty()) return;
  // The tile is looked at from where it was chosen.
  CameraPose pose = window.camera.goal();
  pose.orientation = tiles.camera.goal().orientation;
  window.camera.set(pose);
  window.camera.frame(rerun.box, false);
  window.camera.mark_set();
}

void Steering::take_run() {
  take_walls();
  if (const auto rerun = tiles.take_recording()) show_tile(*rerun);
  const SessionSnapshot& run = window.run;
  if (run.error && run.error->message != error_seen_) {
    error_seen_ = run.error->message;
    window.report(*run.error);
  }
  if (window.shows_recording() && draft_generation_ != run.generation && !run.parameters.input.empty()) {
    draft_generation_ = run.generation;
    window.draft = run.parameters;
  }
  const std::string error = run.recording && run.recording->error ? run.recording->error->message : "";
  if (!error.empty() && error != recording_error_seen_) window.report(*run.recording->error);
  recording_error_seen_ = error;
}

void Steering::ask_preview() {
  const auto state = window.state();
  const bool differs = state && window.run.scene && draft_differs();
  window.forecast = differs ? forecast(window, plan()) : std::nullopt;
  // While a slider moves, what was marked last stays until the next answer.
  if (!differs)
    window.would_violate.reset();
  else if (const auto known = draft_preview())
    window.would_violate = known;
  else if (marked_state_ != state)
    window.would_violate.reset();
  marked_state_ = state;
  if (!differs || window.transport.moving() || !check_draft(window.draft)) return;
  const CriteriaParameters criteria = draft_criteria();
  if (preview_asked_ == criteria && preview_state_ == state) return;
  preview_asked_ = criteria;
  preview_state_ = state;
  window.playhead.request_preview(criteria);
}

} // namespace isoscope
