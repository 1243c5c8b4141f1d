// What happens between two frames: the run's news, the play head, the features in turn.
#include "app/app_model.h"

#include "model/words.h"
#include "steering/steering.h"
#include "view/view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isoscope {

AppModel::AppModel(const std::function<void()>& notify)
    : WindowState(notify), probe(*this, notify), debug(*this, probe, notify), investigation(*this, notify),
      zero_maps(*this, notify), talk(*this), exports(*this, probe, zero_maps),
      comparison(debug, notify, [this] { forget_run(); }), mosaic(*this, notify),
      steering(debug, comparison, mosaic, notify), lessons(*this, commands, values, exports),
      expected_genus_(std::make_shared<std::atomic<double>>(std::nan(""))) {
  debug.breakpoints->set_expected([expected = expected_genus_]() -> std::optional<double> {
    const double genus = expected->load();
    return std::isnan(genus) ? std::nullopt : std::optional(genus);
  });
  camera.set(first_pose());
  add_commands();
  add_values();
}

// The order is that of menus and help.
void AppModel::add_commands() {
  steering.add_file_commands(commands);
  steering.add_recording_commands(commands);
  add_transport_commands(commands, *this);
  debug.add_event_commands(commands);
  add_pace_commands(commands, *this);
  steering.add_run_commands(commands);
  steering.add_parameter_commands(commands);
  steering.add_tolerance_commands(commands);
  debug.add_commands(commands);
  add_pick_commands(commands, *this);
  debug.add_select_commands(commands);
  add_selection_commands(commands, *this);
  probe.add_commands(commands);
  comparison.add_branch_command(commands);
  investigation.add_commands(commands);
  comparison.add_commands(commands);
  add_view_commands(commands, *this);
  add_section_commands(commands, *this, probe);
  zero_maps.add_commands(commands);
  mosaic.add_commands(commands);
  talk.add_commands(commands);
  lessons.add_commands(commands); // behind those whose keys they take while a lesson is on
  exports.add_commands(commands);
  add_window_commands(commands, *this, values);
  add_script_commands(*this);
  commands.move_to_end("quit");
}

void AppModel::add_values() {
  steering.add_parameter_values(values);
  steering.add_plan_values(values);
  add_view_values(values, *this);
  zero_maps.add_values(values);
  add_run_values(values, *this);
  steering.add_tolerance_values(values);
  probe.add_values(values);
  comparison.add_run_values(values);
  debug.add_values(values);
  steering.add_recording_values(values);
  mosaic.add_values(values);
  investigation.add_values(values);
  comparison.add_values(values);
  talk.add_values(values);
  lessons.add_values(values);
  exports.add_values(values);
  comparison.add_history_values(values);
  add_window_values(values, *this);
  add_time_values(*this);
}

void AppModel::abandon() {
  session.abandon();
  comparison.abandon();
  probe.abandon();
  debug.abandon();
  investigation.abandon();
  zero_maps.abandon();
  steering.abandon();
  mosaic.abandon();
}

void AppModel::forget_run() {
  steering.forget();
  selection.pick({});
  selection.hovered = {};
  preview_delta.reset();
  probe.forget();
  history.reset();
  talk.fetch_bookmarks();
  framed_generation_ = history_warned_ = 0;
}

// A camera that was moved stays where it is for a model that lies in the same place, as another version of it
// or another run; for any other the program frames it again. Two runs share what is seen.
void AppModel::meet_input() {
  const TriangleSoup* input = run.scene ? run.scene->input.get() : run.input.get();
  if (std::exchange(exchanges_met_, comparison.exchanges()) != comparison.exchanges())
    exchanged_to_ = run.generation;
  if (input == nullptr || met_generation_ == run.generation) return;
  met_generation_ = run.generation;
  const Box3 box = input->bounds();
  constexpr double alike = 0.05; // of the longest edge
  const double reach = alike * std::max(box.longest_edge(), met_.longest_edge());
  const bool first = met_.empty(),
             same = length(box.lo - met_.lo) <= reach && length(box.hi - met_.hi) <= reach;
  met_ = box;
  // A view that was taken since the run began is meant for it.
  if (first || same || exchanged_to_ == run.generation || !(camera.goal() == pose_before_)) return;
  camera.release();
  section_set = false;
}

// The clip goes to the middle of a loaded model unless somebody had set it.
void AppModel::place_view() {
  if (!run.scene || framed_generation_ == run.generation) return;
  framed_generation_ = run.generation;
  const Box3 box = scene_bounds();
  if (box.empty()) return;
  camera.set_scene_bounds(box);
  if (view.clip.shape == ClipSettings::Shape::none && !section_set) {
    center_clip();
    clip_placed_ = true;
  }
}

void AppModel::watch_history() {
  if (!run.journal || history_warned_ == run.generation) return;
  const HistoryMemory h = comparison.history_memory();
  if (const auto error = run.journal->spill_error()) {
    history_warned_ = run.generation;
    report(*error);
  } else if (h.journal > h.limit) {
    // Once the play head has answered under this limit, what is still above it cannot leave.
    if (running() || !kept_within(comparison.history_share())) return;
    history_warned_ = run.generation;
    report({ErrorCode::usage,
            "The samples and the newest steps alone take " + bytes_text(h.journal) +
                ", more than the history's limit of " + bytes_text(h.limit) +
                ". No keyframes are kept: far steps take longer to reach.",
            "Raise the limit (set history.limit MB, --history-limit MB)."});
  }
}

// Half a second each, on the model's clock.
void AppModel::blink() {
  constexpr double period = 1.0;
  if (!blinking) return;
  view.moment = std::fmod(clock, period) < period / 2 ? Moment::before : Moment::after;
}

// Until somebody moves it, the camera is the program's own, and so are the clip and the section of a new
// model.
void AppModel::watch_view() {
  history.set_window(scripted ? 0 : 0.5);
  unsigned unasked = 0;
  if (!camera.was_set() && !camera_was_set_) unasked |= ViewHistory::camera;
  if (!section_set && !section_was_set_) unasked |= ViewHistory::section;
  camera_was_set_ = camera.was_set();
  section_was_set_ = section_set;
  if (presenter.on && transport.moving()) unasked |= ViewHistory::selection; // of moments
  if (std::exchange(clip_placed_, false)) unasked |= ViewHistory::look;
  if (!state()) unasked = ~0u;
  history.observe(memento(), clock, dragging, unasked);
}

bool AppModel::update(double seconds) {
  const SessionPhase phase = run.phase;
  const auto step_before = transport.step();
  if (take_snapshot()) {
    forget_run();
    pose_before_ = camera.goal();
  }
  const auto genus = run.scene ? expected_genus(*run.scene) : std::nullopt;
  expected_genus_->store(genus.value_or(std::nan("")));
  const bool tiles_changed = mosaic.update();
  steering.take_run();
  meet_input();
  place_view();
  watch_history();
  bool changed = phase != run.phase || running() || tiles_changed;
  changed |= index.update();
  changed |= !scripted && clock - answer.since < AnswerInSight::flash;
  // What a finished run was watched for is its certificate.
  const bool ended = phase != SessionPhase::finished && run.phase == SessionPhase::finished && run.result;
  if (ended && selection.picked.kind == Pick::Kind::none && settings.panes.show_right &&
      transport.mode() == Transport::Mode::following)
    bring_into_sight(AnswerKind::certificate);
  changed |= debug.update();
  transport.set_immediate(scripted);
  talk.update();
  transport.update(std::min(seconds, 0.1), live_step(), growing());
  changed |= transport.step() != step_before;
  request_state(view.tets.recent, comparison.history_share(), transport.moving());
  changed |= comparison.update(seconds);
  for (const Message& m : messages) changed |= !scripted && m.strength(clock) < 1;
  if (!scripted)
    changed |= std::erase_if(messages, [&](const Message& m) {
                 return !m.error && clock - m.since > Message::shown;
               }) > 0;

  changed |= take_result();
  steering.ask_preview();
  const Moment moment = view.moment;
  blink();
  changed |= moment != view.moment || !probe.idle();
  probe.update();
  changed |= investigation.update();
  changed |= zero_maps.update();
  changed |= camera.update(scripted ? 1.0 : seconds);
  watch_view();
  settled = state_is_current();
  return lessons.update() || changed;
}

bool AppModel::state_is_current() const {
  return is_current() && probe.idle() && investigation.idle() && zero_maps.idle() && debug.is_current() &&
         comparison.is_current() && steering.idle();
}

bool AppModel::answers_taken() const {
  return result_taken() && probe.idle() && investigation.idle() && zero_maps.idle() && comparison.at_rest() &&
         steering.idle() && mosaic.idle() && lessons.runner.idle();
}

} // namespace isoscope
