// Records first, then asks the gate: a pause always shows what led to it.
#include "journal/recorder.h"

#include <utility>

namespace isoscope {

Gate::Verdict Recorder::event(Event event) {
  journal_->add_event(event);
  return gate_->pass(*journal_, journal_->events().back());
}

Gate::Verdict Recorder::operation(Event event, Delta delta, const StepFigures& figures) {
  journal_->add_operation(event, delta, figures);
  return gate_->pass(*journal_, journal_->events().back());
}

} // namespace isoscope
