// What the model does with a second run: beginning one, changing to it, ending it.
#include "app/app_model.h"

#include "recording/recording_reader.h"

#include <utility>

namespace isoscope {

void AppModel::show_second(std::unique_ptr<ShownRun> second) {
  comparison.take(std::move(second), false, true);
  if (view.mode == ViewMode::split) view.mode = ViewMode::scene; // two views of two runs would be four
  settings.panes.tab = comparison_tab;
  settings.panes.show_bottom = true;
}

Status AppModel::run_beside() {
  if (!run.scene) return Error{ErrorCode::usage, "There is no run yet.", "Open a model first."};
  auto second = std::make_unique<ShownRun>(notify_);
  // The input may be on another machine, or changed meanwhile: the run has it.
  if (draft.input == run.parameters.input)
    second->session.start(draft, run.scene->input, false, run.scene->notes);
  else
    second->session.start(draft);
  draft = run.parameters;
  show_second(std::move(second));
  return {};
}

Status AppModel::open_beside(const std::string& input) {
  auto second = std::make_unique<ShownRun>(notify_);
  if (is_recording_name(input)) {
    second->session.open_recording(input);
  } else {
    RunParameters parameters = draft;
    parameters.input = input;
    second->session.start(std::move(parameters));
  }
  overlay = Overlay::none;
  show_second(std::move(second));
  return {};
}

Status AppModel::change_run() {
  if (!comparison.other())
    return Error{ErrorCode::usage, "There is no other run.", "Run one beside this one, or branch it."};
  // A run that nobody sees need not compute.
  if (!comparison.beside() && run.phase == SessionPhase::running) session.pause();
  session.set_breakpoint({}); // breakpoints stop the active run alone
  debug.armed = false;
  debug.breakpoints->forget_hits();
  comparison.exchange(*this);
  take_snapshot();
  debug.held_generation = run.generation; // why it paused was told when it did
  debug.held_events = run.journal ? run.journal->events().size() : 0;
  forget_run();
  draft = run.parameters;
  framed_generation_ = draft_generation_ = history_warned_ = 0;
  return {};
}

void AppModel::close_other() {
  comparison.drop();
  if (settings.panes.tab == comparison_tab) settings.panes.tab = 0;
}

} // namespace isoscope
