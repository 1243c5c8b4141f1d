// Beginning a second run, changing to it, ending it.
#include "two_runs/comparison.h"

#include "model/chosen_input.h"
#include "recording/copy_reader.h"
#include "run/sample_memory.h"

#include <utility>

namespace isoscope {

void Comparison::show_second(std::unique_ptr<ShownRun> second) {
  take(std::move(second), false, true);
  // Two views of two runs would be four.
  if (window.view.mode == ViewMode::split) window.view.mode = ViewMode::scene;
  window.open_tab(BottomTab::compare);
}

Status Comparison::run_beside() {
  if (!window.run.scene) return Error{ErrorCode::usage, "There is no run yet.", "Open a model first."};
  if (Status right = check(window.draft); !right) return right;
  auto second = std::make_unique<ShownRun>(notify_);
  // The input may be on another machine, or changed meanwhile: the run has it.
  if (window.draft.input == window.run.parameters.input)
    second->session.start(window.draft, window.run.scene->input, false, window.run.scene->notes);
  else
    second->session.start(window.draft);
  window.draft = window.run.parameters;
  show_second(std::move(second));
  return {};
}

Status Comparison::open_beside(const std::string& input) {
  auto second = std::make_unique<ShownRun>(notify_);
  if (is_recording_name(input) && lies_elsewhere(input)) {
    second->session.follow_copy(input);
  } else if (is_recording_name(input)) {
    second->session.open_recording(input);
  } else {
    second->session.start(for_input(window.draft, input));
  }
  window.overlay = Overlay::none;
  show_second(std::move(second));
  return {};
}

Status Comparison::branch_here() {
  const auto shown = debug.probe.xray();
  const auto tried = debug.probe.study();
  if (!shown || !tried)
    return Error{ErrorCode::usage, "No target is tried.", "Select an edge of T and choose a target first."};
  const SessionSnapshot& run = window.run;
  const Step step = window.state()->step - (shown->before ? 1 : 0);
  if (Status can = can_branch(*run.journal, step); !can) return can;
  if (!tried->attempt.possible())
    return Error{ErrorCode::usage,
                 "The edge cannot be collapsed there: " + std::string(name(tried->attempt.rejected)) + ".",
                 "Move the target until every check passes."};
  auto branch = std::make_unique<ShownRun>(notify_);
  branch->session.start_branch({run.journal, step, shown->star.a(), shown->star.b(), tried->target},
                               run.parameters, *run.scene, run.generation);
  // The branch becomes the active run; what it leaves is A.
  take(std::move(branch), false, beside());
  return change_run();
}

Status Comparison::branch_with_draft(Step step) {
  const SessionSnapshot& run = window.run;
  if (!run.scene || !run.journal)
    return Error{ErrorCode::usage, "There is no run yet.", "Open a model first."};
  if (Status can = can_go_on(*run.journal, step); !can) return can;
  const RunParameters wanted = window.draft;
  const double sigma = wanted.criteria(run.scene->delta, run.scene->default_sigma).sigma;
  if (Status fits = check_memory(run.scene->sample_estimate, sigma, run.scene->delta, wanted.most_bytes());
      !fits)
    return fits;
  auto branch = std::make_unique<ShownRun>(notify_);
  branch->session.start_branch({run.journal, step, {}, {}, {}}, wanted, *run.scene, run.generation);
  // What comes is what is new: the play head need not play up to it.
  branch->transport.jump(step);
  branch->transport.follow();
  take(std::move(branch), false, beside());
  return change_run();
}

Status Comparison::change_run() {
  if (!other_)
    return Error{ErrorCode::usage, "There is no other run.", "Run one beside this one, or branch it."};
  // A run that nobody sees need not compute.
  if (!beside() && window.run.phase == SessionPhase::running) window.session.pause();
  debug.disarm();
  exchange();
  window.take_snapshot();
  debug.take_pause_as_told();
  window.draft = window.run.parameters;
  changed_();
  return {};
}

void Comparison::close_other() {
  drop();
  if (window.settings.panes.tab == BottomTab::compare) window.settings.panes.tab = BottomTab::timeline;
}

void Comparison::abandon() {
  if (other_) other_->session.abandon();
}

} // namespace isoscope
