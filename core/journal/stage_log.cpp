// Stamps events with their stage and its time.
#include "journal/stage_log.h"

#include <utility>

namespace isoscope {

void StageLog::begin(Stage stage, bool further) {
  stage_ = stage;
  began_ = std::chrono::steady_clock::now();
  Event e;
  e.kind = EventKind::stage_begin;
  e.count = further ? 1 : 0;
  event(e);
}

void StageLog::rejoin(Stage stage, double seconds) {
  stage_ = stage;
  began_ = std::chrono::steady_clock::now() - std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                  std::chrono::duration<double>(seconds));
}

void StageLog::end() {
  Event e;
  e.kind = stopped() ? EventKind::stopped : EventKind::stage_end;
  event(e);
}

void StageLog::event(Event event) {
  event.stage = stage_;
  hear(recorder_->event(event));
}

void StageLog::operation(Event event, Delta delta, StepFigures figures) {
  event.stage = stage_;
  event.operation = true;
  if (const Rehearsal* ahead = rehearsal(); ahead != nullptr && !ahead->over() && ahead->event().operation)
    rejoin(stage_, ahead->seconds());
  figures.seconds = std::chrono::duration<float>(std::chrono::steady_clock::now() - began_).count();
  hear(recorder_->operation(event, std::move(delta), figures));
}

void StageLog::warn(std::string text) {
  Event e;
  e.kind = EventKind::warning;
  e.text = recorder_->journal().add_text(std::move(text));
  event(e);
}

void StageLog::hear(Gate::Verdict verdict) {
  stopped_ |= verdict == Gate::Verdict::stop;
  if (verdict == Gate::Verdict::parameters_changed && adopt_) adopt_(recorder_->gate().wanted_parameters());
  hear_followed();
}

void StageLog::hear_followed() {
  const Rehearsal* ahead = rehearsal();
  if (ahead == nullptr || recorder_->astray()) return;
  const EventKind next = ahead->event().kind;
  stopped_ |= next == EventKind::stopped;
  if (next == EventKind::parameter_change && adopt_) adopt_(ahead->criteria());
}

} // namespace isoscope
