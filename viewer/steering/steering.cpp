// What is asked of the session, and what the draft of the parameters would change.
#include "steering/steering.h"

#include "input/gallery.h"
#include "recording/recording_reader.h"

namespace isoscope {
namespace {

constexpr std::string_view gallery_prefix = "gallery:";

} // namespace

void Steering::open(const std::string& input, bool paused) {
  window.draft.input = input;
  if (input.starts_with(gallery_prefix)) {
    for (const GalleryEntry& entry : gallery())
      if (entry.name == std::string_view(input).substr(gallery_prefix.size()))
        window.draft.tolerance = {entry.tolerance_percent, true};
  } else if (!window.scripted) {
    window.settings.add_recent(input);
  }
  window.overlay = Overlay::none;
  window.transport.restart();
  debug.breakpoints->forget_hits();
  if (is_recording_name(input))
    window.session.open_recording(input);
  else
    window.session.start(window.draft, nullptr, paused);
}

void Steering::restart() {
  if (window.draft.input.empty()) return;
  window.transport.restart();
  debug.breakpoints->forget_hits();
  // The input of a recording may be on another machine: the recording holds it.
  const bool stored =
      window.shows_recording() && window.run.scene && window.draft.input == window.run.parameters.input;
  if (stored)
    window.session.start(window.draft, window.run.scene->input, false, window.run.scene->notes);
  else
    window.session.start(window.draft);
}

Status Steering::apply() {
  if (Status fits = window.session.apply(window.draft); !fits) return fits;
  window.transport.follow();
  return {};
}

bool Steering::draft_needs_restart() const {
  const RunParameters& p = window.run.parameters;
  return window.draft.input != p.input || window.draft.tolerance.value != p.tolerance.value ||
         window.draft.tolerance.percent != p.tolerance.percent || window.draft.containment != p.containment ||
         window.draft.topology != p.topology || window.draft.until != p.until ||
         window.draft.skipped != p.skipped || window.draft.target != p.target ||
         window.draft.cost_ring != p.cost_ring || window.draft.effort != p.effort ||
         window.draft.improver != p.improver || window.draft.drop_thin != p.drop_thin ||
         window.draft.cover != p.cover || window.draft.drop_small != p.drop_small;
}

bool Steering::draft_differs() const {
  const RunParameters& p = window.run.parameters;
  return draft_needs_restart() || window.draft.sigma_ratio() != p.sigma_ratio() ||
         window.draft.alpha != p.alpha || window.draft.shrink != p.shrink ||
         window.draft.condition_1 != p.condition_1 || window.draft.condition_2 != p.condition_2 ||
         window.draft.condition_3 != p.condition_3 || window.draft.condition_4 != p.condition_4;
}

CriteriaParameters Steering::draft_criteria() const {
  return window.run.scene ? window.draft.criteria(window.run.scene->delta, window.run.scene->default_sigma)
                          : window.draft.criteria(0);
}

std::optional<ViolationPreview> Steering::draft_preview() const {
  const auto preview = window.playhead.preview();
  if (!preview || preview->criteria != draft_criteria()) return std::nullopt;
  return preview->violations;
}

void Steering::forget() {
  preview_asked_.reset();
  error_seen_.clear();
  draft_generation_ = 0;
}

void Steering::take_run() {
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
  if (!state || !window.run.scene || !draft_differs() || window.transport.moving()) return;
  const CriteriaParameters criteria = draft_criteria();
  if (preview_asked_ == criteria && preview_state_ == state) return;
  preview_asked_ = criteria;
  preview_state_ = state;
  window.playhead.request_preview(criteria);
}

} // namespace isoscope
