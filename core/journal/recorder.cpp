// Records first, then asks the gate: a pause always shows what led to it.
#include "journal/recorder.h"

#include <utility>

namespace isoscope {

Gate::Verdict Recorder::event(Event event) {
  journal_->add_event(event);
  if (rehearsal_) return followed(event);
  return gate_->pass(*journal_, journal_->events().back());
}

Gate::Verdict Recorder::operation(Event event, Delta delta, const StepFigures& figures) {
  journal_->add_operation(event, delta, figures);
  if (rehearsal_) return followed(event);
  return gate_->pass(*journal_, journal_->events().back());
}

void Recorder::rehearse(Journal& scratch, std::size_t next) {
  kept_ = std::exchange(journal_, &scratch);
  rehearsal_.emplace(*kept_, next);
}

Gate::Verdict Recorder::followed(const Event& made) {
  if (astray_ || !rehearsal_->advance(made)) {
    astray_ = true;
    return Gate::Verdict::stop;
  }
  if (!rehearsal_->over()) return Gate::Verdict::go_on;
  rehearsal_.reset();
  journal_ = kept_;
  return gate_->pass(*journal_, journal_->events().back());
}

} // namespace isoscope
