// What happens between two frames: the run's news, the play head, the workers.
#include "app/app_model.h"

#include "debug/debug_actions.h"
#include "model/words.h"
#include "input/gallery.h"
#include "recording/recording_reader.h"
#include "scene/section_view.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

constexpr std::size_t message_limit = 4;
constexpr double note_seconds = 8; ///< after which what is no error goes away by itself

/// From above right in front: depth is seen at once.
CameraPose first_pose() {
  CameraPose pose;
  const double yaw = 0.6 / 2, pitch = -0.42 / 2;
  const double cy = std::cos(yaw), sy = std::sin(yaw), cp = std::cos(pitch), sp = std::sin(pitch);
  pose.orientation = {cy * sp, sy * cp, -sy * sp, cy * cp};
  pose.fov = 35;
  return pose;
}

} // namespace

AppModel::AppModel(std::function<void()> notify)
    : ShownRun(notify), probe(notify), unlocks(unlocks_of, notify), investigation(notify), debug(notify),
      comparison(notify), notify_(std::move(notify)),
      expected_genus_(std::make_shared<std::atomic<double>>(std::nan(""))) {
  debug.breakpoints->set_expected([expected = expected_genus_]() -> std::optional<double> {
    const double genus = expected->load();
    return std::isnan(genus) ? std::nullopt : std::optional(genus);
  });
  camera.set(first_pose());
}

void AppModel::open(const std::string& input, bool paused) {
  draft.input = input;
  if (input.starts_with(gallery_prefix)) {
    if (const GalleryEntry* entry = gallery_entry(input)) draft.tolerance = {entry->tolerance_percent, true};
  } else if (!scripted) {
    settings.add_recent(input);
  }
  overlay = Overlay::none;
  transport.restart();
  debug.breakpoints->forget_hits();
  if (is_recording_name(input))
    session.open_recording(input);
  else
    session.start(draft, nullptr, paused);
}

void AppModel::restart() {
  if (draft.input.empty()) return;
  transport.restart();
  debug.breakpoints->forget_hits();
  // The input of a recording may be on another machine: the recording holds it.
  const bool stored = shows_recording() && run.scene && draft.input == run.parameters.input;
  if (stored)
    session.start(draft, run.scene->input, false, run.scene->notes);
  else
    session.start(draft);
}

Status AppModel::apply() {
  if (Status fits = session.apply(draft); !fits) return fits;
  transport.follow();
  return {};
}

bool AppModel::draft_needs_restart() const {
  return fields_differ(draft, run.parameters, [](const FieldFacts& f) { return f.restart; });
}

bool AppModel::draft_differs() const {
  const double by_default = run.scene ? run.scene->default_sigma : 0.5;
  RunParameters wanted = draft, now = run.parameters;
  for (RunParameters* p : {&wanted, &now}) p->sigma = p->sigma_ratio(by_default);
  return fields_differ(wanted, now, [](const FieldFacts&) { return true; });
}

void AppModel::abandon() {
  session.abandon();
  if (ShownRun* other = comparison.other()) other->session.abandon();
  unlocks.abandon();
  debug.worker.abandon();
  investigation.abandon();
}

void AppModel::report(const Error& error) {
  messages.push_back({true, error.message, error.remedy, clock});
  while (messages.size() > message_limit) messages.pop_front();
}

void AppModel::tell(std::string text) {
  messages.push_back({false, std::move(text), "", clock});
  while (messages.size() > message_limit) messages.pop_front();
}

CriteriaParameters AppModel::draft_criteria() const {
  return run.scene ? draft.criteria(run.scene->delta, run.scene->default_sigma) : draft.criteria(0);
}

std::optional<ViolationPreview> AppModel::draft_preview() const {
  const auto preview = playhead.preview();
  if (!preview || preview->criteria != draft_criteria()) return std::nullopt;
  return preview->violations;
}

void AppModel::forget_run() {
  preview_asked_.reset();
  selection.pick({});
  selection.hovered = {};
  xray_asked_.reset();
  history.reset();
  fetch_bookmarks();
  error_seen_.clear();
}

void AppModel::take_run() {
  if (take_snapshot())
    forget_run();
  else if (shows_recording() && run.recording->file != bookmarks_recording_)
    fetch_bookmarks();
  if (moments.journal() != run.journal) moments.reset(run.journal);
  const auto genus = run.scene ? expected_genus(*run.scene) : std::nullopt;
  expected_genus_->store(genus.value_or(std::nan("")));
  if (run.error && run.error->message != error_seen_) {
    error_seen_ = run.error->message;
    report(*run.error);
  }
  take_recording();
}

void AppModel::take_recording() {
  if (shows_recording() && draft_generation_ != run.generation && !run.parameters.input.empty()) {
    draft_generation_ = run.generation;
    draft = run.parameters;
  }
  const std::string error = run.recording && run.recording->error ? run.recording->error->message : "";
  if (!error.empty() && error != recording_error_seen_) report(*run.recording->error);
  recording_error_seen_ = error;
}

// The clip goes to the middle of a loaded model unless somebody had set it.
void AppModel::place_view() {
  if (!run.scene || framed_generation_ == run.generation) return;
  framed_generation_ = run.generation;
  const Box3 box = scene_bounds();
  if (box.empty()) return;
  camera.set_scene_bounds(box);
  if (view.clip.shape == ClipSettings::Shape::none && !section_set) {
    view.clip.point = box.center();
    view.clip.radius = 0.15 * box.longest_edge();
    clip_placed_ = true;
  }
}

AppModel::HistoryMemory AppModel::history_memory() const {
  HistoryMemory h;
  h.limit = static_cast<std::size_t>(settings.history_limit * 1048576.0);
  for (const ShownRun* each : {static_cast<const ShownRun*>(this), comparison.other()}) {
    if (each == nullptr) continue;
    h.journal += each->run.journal ? each->run.journal->memory_bytes() : 0;
    h.keyframes += each->keyframe_bytes();
    h.disk += each->run.journal ? each->run.journal->disk_bytes() : 0;
  }
  return h;
}

std::size_t AppModel::history_share() const {
  return history_memory().limit / (comparison.other() ? 2 : 1);
}

void AppModel::watch_history() {
  if (!run.journal || history_warned_ == run.generation) return;
  const HistoryMemory h = history_memory();
  if (const auto error = run.journal->spill_error()) {
    history_warned_ = run.generation;
    report(*error);
  } else if (h.journal > h.limit) {
    // Once the play head has answered under this limit, what is still above it cannot leave.
    if (running() || !kept_within(history_share())) return;
    history_warned_ = run.generation;
    report({ErrorCode::usage,
            "The samples and the newest steps alone take " + bytes_text(h.journal) +
                ", more than the history's limit of " + bytes_text(h.limit) +
                ". No keyframes are kept: far steps take longer to reach.",
            "Raise the limit (set history.limit MB, --history-limit MB)."});
  }
}

std::optional<std::uint32_t> AppModel::selected_event() const {
  const auto shown = state();
  if (!shown || !run.journal || selection.picked.kind != Pick::Kind::edge) return std::nullopt;
  if (selection.event && *selection.event < run.journal->events().size()) {
    const Event& e = run.journal->events()[*selection.event];
    if (e.step == shown->step || (e.operation && e.step + 1 == shown->step)) return selection.event;
  }
  return edge_event(*run.journal, shown->step, VertexId(selection.picked.id),
                    VertexId(selection.picked.other));
}

ViewSettings AppModel::shown_view() const {
  ViewSettings shown = view;
  const bool heat = settings.panes.tab == work_tab && settings.panes.show_bottom;
  const bool element = selection.picked.kind == Pick::Kind::edge || selection.picked.kind == Pick::Kind::tet;
  if (!view.focus || !(element || heat)) return shown;
  constexpr float step_back = 0.35f;
  shown.samples.visible = false;
  if (selection.picked.kind == Pick::Kind::tet) {
    shown.highlight.visible = shown.tets.violate_3 = false;
    shown.zero_set.opacity *= step_back;
  }
  shown.outer.opacity *= step_back;
  shown.inner.opacity *= step_back;
  shown.tets.changed = false;
  return shown;
}

std::shared_ptr<const EdgeXray> AppModel::xray() const {
  const auto newest = probe.result();
  return newest && xray_asked_ && newest->request.same_edge(*xray_asked_) && newest->request.state == state()
             ? newest->xray
             : nullptr;
}

void AppModel::request_xray() {
  if (selection.picked.kind != Pick::Kind::edge) xray_asked_.reset();
  const auto shown = state();
  if (!shown || !run.journal || !run.scene || selection.picked.kind != Pick::Kind::edge) return;
  ProbeRequest wanted;
  wanted.state = shown;
  wanted.journal = run.journal;
  wanted.scene = run.scene;
  wanted.index = sample_index();
  wanted.parameters = run.parameters;
  wanted.question = {VertexId(selection.picked.id), VertexId(selection.picked.other), selected_event(),
                     selection.target};
  wanted.target = selection.what_if;
  if (const auto shown_xray = xray(); shown_xray && selection.hovered_candidate)
    if (const auto i = *selection.hovered_candidate; i < shown_xray->attempt.candidates.size())
      wanted.target = shown_xray->attempt.candidates[i].point;
  if (xray_asked_ == wanted) return;
  xray_asked_ = wanted;
  probe.request(std::move(wanted));
}

// Half a second each, on the model's clock.
void AppModel::blink() {
  constexpr double period = 1.0;
  if (!blinking) return;
  view.moment = std::fmod(clock, period) < period / 2 ? Moment::before : Moment::after;
}

bool AppModel::update(double seconds) {
  const SessionPhase phase = run.phase;
  const auto step_before = transport.step();
  take_run();
  place_view();
  watch_history();
  bool changed = phase != run.phase || running();
  changed |= index.update();
  changed |= update_debugger(*this);
  transport.set_immediate(scripted);
  moments.update();
  transport.dwell_at(presenter.on && presenter.slow_down ? moments.steps() : std::span<const Step>());
  transport.update(std::min(seconds, 0.1), live_step(), growing());
  changed |= transport.step() != step_before;
  request_state(view.tets.recent, history_share(), transport.moving());
  changed |= comparison.update(*this, seconds);
  if (!scripted)
    changed |= std::erase_if(messages, [&](const Message& m) {
                 return !m.error && clock - m.since > note_seconds;
               }) > 0;

  changed |= take_result();
  if (state() && run.scene && draft_differs() && !transport.moving()) {
    const CriteriaParameters criteria = draft_criteria();
    if (preview_asked_ != criteria || preview_state_ != state()) {
      preview_asked_ = criteria;
      preview_state_ = state();
      playhead.request_preview(criteria);
    }
  }
  const Moment moment = view.moment;
  blink();
  changed |= moment != view.moment || !probe.idle() || !unlocks.idle();
  request_xray();
  changed |= investigation.update(*this);
  changed |= camera.update(scripted ? 1.0 : seconds);
  watch_view();
  return changed;
}

bool AppModel::state_is_current() const {
  return is_current() && probe.idle() && unlocks.idle() && investigation.idle() &&
         debugger_is_current(*this) && comparison.is_current(*this);
}

} // namespace isoscope
