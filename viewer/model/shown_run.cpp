// The way from the session's snapshot to the state shown.
#include "model/shown_run.h"

#include "base/numbers.h"
#include "base/sort_unique.h"
#include "journal/vocabulary.h"
#include "questions/rim_questions.h"
#include "scene/outline.h"

#include <algorithm>

namespace isoscope {

/// Both take a look at every point.
void ShownRun::measure_input() {
  const auto& input = run.scene ? run.scene->input : run.input;
  const double margin = run.scene ? run.scene->delta : 0;
  if (input == measured_ && margin == margin_) return;
  measured_ = input;
  margin_ = margin;
  bounds_ = input ? input->bounds().grown(margin) : Box3();
  outline_ = input ? outline(*input, margin) : std::vector<Vec3>();
}

bool ShownRun::take_snapshot() {
  run = session.snapshot();
  const bool another = run.generation != generation_;
  if (another) {
    generation_ = run.generation;
    playhead.clear();
    result_.reset();
    asked_.reset();
    index.reset(nullptr);
    preparation_.begin();
    since_began_ = Stopwatch();
  }
  if (run.phase == SessionPhase::preparing)
    preparation_.report(run.part, run.fraction, since_began_.seconds());
  measure_input();
  if (run.journal && index.journal() != run.journal) index.reset(run.journal);
  if (run.scene != scene_seen_) {
    scene_seen_ = run.scene;
    grid.want(run.scene);
  }
  return another;
}

void ShownRun::request_state(Step recent, std::size_t history_limit, bool moving) {
  if (!run.journal) return;
  PlayheadRequest wanted;
  wanted.generation = run.generation;
  wanted.journal = run.journal;
  wanted.step = transport.step();
  wanted.sampled = !run.journal->sample_sets().empty();
  wanted.history_limit = history_limit;
  wanted.options.recent = recent;
  wanted.options.orientation = !moving || (transport.at_live_end(live_step()) && !running());
  if (moving && asked_ && !playhead.idle()) return;
  if (asked_ == wanted) return;
  asked_ = wanted;
  playhead.request(std::move(wanted));
}

bool ShownRun::take_result() {
  const auto newest = playhead.result();
  if (newest == result_ || (newest && newest->request.generation != run.generation)) return false;
  result_ = newest;
  return true;
}

bool ShownRun::is_current() const {
  if (!playhead.idle() || !index.complete() || grid.working() || grid.refining()) return false;
  if (!run.journal) return true;
  return result_ && asked_ && result_->request == *asked_ && asked_->step == transport.step() &&
         (!transport.moving() || transport.step() >= live_step());
}

std::vector<std::int8_t> ShownRun::side_labels() const {
  std::vector<std::int8_t> labels;
  for (const Region& r : run.scene ? run.scene->regions : std::vector<Region>())
    labels.push_back(static_cast<std::int8_t>(r.label));
  sort_unique(labels);
  std::reverse(labels.begin(), labels.end());
  return labels;
}

const Rim* ShownRun::rim() const {
  return run.scene ? open_rim(*run.scene) : nullptr;
}

std::vector<std::string> ShownRun::warnings() const {
  std::vector<std::string> texts;
  if (no_thickening()) texts.push_back(run.scene->thickening_note);
  if (run.scene)
    for (const ParameterWarning& warning : run.scene->warnings) texts.push_back(warning.message);
  return texts;
}

std::string ShownRun::why_bad_may_stay() const {
  const auto shown = state();
  if (!run.scene || !shown || shown->bad_samples == 0 || !shown->event ||
      !comes_after(shown->event->stage, Stage::refinement))
    return {};
  const ToleranceThresholds& t = run.scene->thresholds;
  if (!(t.boundary < t.delta)) return {};
  return "Samples lie at " + general(t.boundary / t.delta, 3) +
         " δ. After the refinement facets of Z are proven within δ instead: Z may pass samples and is in Ω "
         "all the same.";
}

} // namespace isoscope
