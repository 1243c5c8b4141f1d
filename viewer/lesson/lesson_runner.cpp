// From stop to stop: commands one after the other, each when the one before is shown.
#include "lesson/lesson_runner.h"

#include "model/chosen_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace isoscope {
namespace {

constexpr double hint_after = 25; ///< seconds
constexpr int digits = 3, most_digits = 15;
/// Whole numbers whose thousands are set apart.
constexpr double first_grouped = 10000, last_grouped = 1e15;

} // namespace

std::string_view name(LessonPhase phase) {
  constexpr std::array<std::string_view, 8> names{"off",    "working", "asking",   "revealing",
                                                  "trying", "reading", "finished", "failed"};
  return names[static_cast<std::size_t>(phase)];
}

std::string with_values(std::string_view text, const NamedValues& values) {
  std::string out;
  while (!text.empty()) {
    const std::size_t open = std::min(text.find('{'), text.size());
    out += text.substr(0, open);
    text.remove_prefix(open);
    const std::size_t close = text.find('}');
    if (text.empty() || close == std::string_view::npos) break;
    std::string_view inside = text.substr(1, close - 1);
    text.remove_prefix(close + 1);
    const std::size_t colon = inside.find(':');
    const auto wanted =
        colon != std::string_view::npos ? read_number(inside.substr(colon + 1)) : std::nullopt;
    const std::string_view word = inside.substr(0, colon);
    const NamedValue* value = values.find(word);
    const std::string found = value != nullptr ? value->get() : std::string(word) + "?";
    const auto number = read_number(found);
    if (number && std::floor(*number) != *number)
      out += general(*number, wanted ? std::clamp(static_cast<int>(*wanted), 1, most_digits) : digits);
    else
      out += number && *number >= first_grouped && *number < last_grouped
                 ? grouped(static_cast<std::size_t>(*number))
                 : found;
  }
  return out += text;
}

std::string with_gaps(std::string_view text) {
  std::string out;
  for (bool inside = false; const char c : text) {
    if (c == '{') out += "\u2026";
    if (!inside && c != '{') out += c;
    inside = c == '{' || (inside && c != '}');
  }
  return out;
}

const LessonStop* LessonRunner::shown() const {
  return lesson_ != nullptr && stop_ < lesson_->stops.size() ? &lesson_->stops[stop_] : nullptr;
}

bool LessonRunner::hinted() const {
  return phase_ == LessonPhase::trying && window_.clock >= hint_at_;
}

std::size_t LessonRunner::asked() const {
  return static_cast<std::size_t>(
      std::count_if(results_.begin(), results_.end(), [](const auto& r) { return r.has_value(); }));
}

std::size_t LessonRunner::right() const {
  return static_cast<std::size_t>(
      std::count_if(results_.begin(), results_.end(), [](const auto& r) { return r.value_or(false); }));
}

std::string LessonRunner::filled(std::string_view text) const {
  std::string words = phase_ == LessonPhase::working ? with_gaps(text) : with_values(text, values_);
  std::erase(words, '`');
  return words;
}

std::string LessonRunner::text() const {
  return shown() != nullptr ? filled(shown()->text) : std::string();
}

std::string LessonRunner::why() const {
  const LessonStop* stop = shown();
  return stop != nullptr && stop->question ? with_values(stop->question->why, values_) : std::string();
}

void LessonRunner::enter(LessonPhase phase) {
  phase_ = phase;
  if (phase != LessonPhase::working) window_.scene_awaited = false;
  if (phase == LessonPhase::trying) hint_at_ = window_.clock + hint_after;
}

void LessonRunner::fail(std::string what) {
  error_ = std::move(what);
  pending_.clear();
  enter(LessonPhase::failed);
}

void LessonRunner::follow(const std::vector<std::string>& commands, LessonPhase phase) {
  pending_.assign(commands.rbegin(), commands.rend());
  tried_at_ = 0;
  enter(phase);
}

void LessonRunner::keep_look() {
  if (before_) return;
  before_ = {window_.memento(), window_.camera.was_set(), window_.section_set};
  window_.lend_layout(LayoutGuest::lesson);
}

void LessonRunner::give_look_back() {
  if (!before_) return;
  ViewMemento& look = before_->look;
  look.view.view.theme = window_.view.theme;
  look.picked = {}; // of another run
  look.event.reset();
  // Two views that came in the meantime stay, and keep their room.
  const PaneLayout kept = window_.kept_layout();
  window_.end_loan(LayoutGuest::lesson);
  if (!window_.has_guest(LayoutGuest::two_views)) look.panes = kept;
  window_.requests.frame_selection = false;
  window_.take(look);
  if (!before_->camera_set) window_.camera.release();
  window_.section_set = before_->section_set;
  before_.reset();
}

Status LessonRunner::open(const Lesson& lesson) {
  RunParameters wanted = for_input(RunParameters(), lesson.model);
  wanted.threads = window_.draft.threads;
  window_.draft = std::move(wanted);
  for (const std::string& setting : lesson.settings)
    if (Status set = commands_.run(commands_.parse("set " + setting)); !set) return set;
  generation_ = window_.run.generation;
  own_.reset();
  if (Status begun = commands_.run({"restart", {}}); !begun) return begun;
  window_.scene_awaited = true;
  return {};
}

Status LessonRunner::begin(const Lesson& lesson, std::size_t stop) {
  // A run that is beside this one, of the lesson before perhaps, has no place in a prepared scene.
  if (window_.has_guest(LayoutGuest::two_views))
    if (Status hidden = commands_.run({"side-by-side", {}}); !hidden) return hidden;
  keep_look();
  if (Status opened = open(lesson); !opened) {
    if (lesson_ == nullptr) give_look_back();
    return opened;
  }
  lesson_ = &lesson;
  results_.assign(lesson.stops.size(), std::nullopt);
  window_.overlay = Overlay::none;
  go(stop);
  return {};
}

void LessonRunner::end() {
  lesson_ = nullptr;
  pending_.clear();
  error_.clear();
  enter(LessonPhase::off);
  give_look_back();
}

void LessonRunner::go(std::size_t stop) {
  if (lesson_ == nullptr) return;
  stop_ = std::min(stop, lesson_->stops.size());
  guess_.reset();
  task_done_ = false;
  error_.clear();
  if (shown() == nullptr) return enter(LessonPhase::finished);
  // What was tried may have been a run with other parameters.
  const bool strayed = own_ && window_.run.generation != *own_ && !window_.has_guest(LayoutGuest::two_views);
  if (strayed)
    if (Status opened = open(*lesson_); !opened) return fail(opened.error().line());
  if (own_) window_.draft = window_.run.parameters; // what was tried in the panel
  ViewSettings plain;
  plain.theme = window_.view.theme;
  window_.view = plain;
  window_.center_clip();
  window_.selection = {};
  window_.inspected = {}; // what it tells begins at the top
  window_.filter = {};
  window_.blinking = false;
  window_.preview_delta.reset();
  window_.camera.set(first_pose()); // a prepared scene is seen from one side, whatever was seen before
  window_.frame_all();
  // What questions keep for themselves.
  for (const auto& [name, value] : {std::pair{"inspect.shrink", "0"}, {"topology.shown", "off"}})
    if (const NamedValue* kept = values_.find(name)) static_cast<void>(kept->set(value));
  PaneLayout& panes = window_.settings.panes;
  panes.show_left = panes.show_right = panes.show_bottom = false;
  // Panes come first: what is framed is framed in the room that they leave.
  std::vector<std::string> commands = shown()->commands;
  std::stable_partition(commands.begin(), commands.end(),
                        [](const std::string& command) { return command.starts_with("pane-"); });
  follow(commands, LessonPhase::working);
}

Status LessonRunner::answer(std::size_t which) {
  const LessonStop* stop = shown();
  if (phase_ != LessonPhase::asking || stop == nullptr) return usage("Nothing is asked now.");
  if (which >= stop->question->answers.size())
    return usage("There is no answer " + std::to_string(which + 1) + ".");
  guess_ = which;
  if (!results_[stop_]) results_[stop_] = stop->question->answers[which].right;
  follow(stop->question->reveal, LessonPhase::revealing);
  return {};
}

bool LessonRunner::passes(const std::vector<std::string>& checks) {
  for (const std::string& check : checks) {
    const Status holds = values_.expect(check);
    if (holds) continue;
    fail("What \"" + shown()->heading + "\" says does not hold: " + holds.error().message);
    return false;
  }
  return true;
}

void LessonRunner::update() {
  const LessonStop* stop = shown();
  if (stop == nullptr) return;
  if (phase_ == LessonPhase::trying && window_.settled && values_.expect(stop->task->until)) {
    task_done_ = true;
    enter(LessonPhase::reading);
  }
  if (idle()) return;
  if (window_.run.generation == generation_) return; // the run that was there before
  if (!own_) own_ = window_.run.generation;
  if (window_.run.error && !window_.running()) return fail(window_.run.error->line());
  if (window_.run.phase == SessionPhase::preparing) return; // nothing is known yet
  if (!window_.has_state()) return;
  const bool running = window_.running();
  // A scene that is prepared is not played up to. What comes first needs nothing to be shown before it, and
  // what the run has not come to yet is tried again.
  const bool follows = window_.transport.mode() == Transport::Mode::following;
  if (follows) window_.transport.follow();
  if (!window_.settled && !(follows && running)) return;
  if (!pending_.empty()) {
    const std::size_t events = window_.run.journal->events().size();
    if (tried_at_ != 0 && tried_at_ == events && running) return;
    if (pending_.back() == "wait") {
      if (!running) pending_.pop_back();
      return;
    }
    const Status done = commands_.run(commands_.parse(pending_.back()));
    if (done) {
      tried_at_ = 0;
      pending_.pop_back();
    } else if (running) {
      tried_at_ = events; // it may come yet
    } else {
      fail("\"" + pending_.back() + "\": " + done.error().message);
    }
    return;
  }
  if (phase_ == LessonPhase::revealing)
    return passes(stop->question->checks) ? enter(LessonPhase::reading) : void();
  if (!passes(stop->checks)) return;
  enter(stop->question ? LessonPhase::asking : stop->task ? LessonPhase::trying : LessonPhase::reading);
}

} // namespace isoscope
