// What an algorithm sees of the journal: it records, and at each operation it may be held, stopped or given
// new parameters.
#pragma once

#include "journal/journal.h"

namespace isoscope {

/// Asked after every event; may block while the run is paused. Implemented by the session; the batch
/// program's never blocks.
class Gate {
 public:
  enum class Verdict {
    go_on,
    stop,              ///< end the stage now; what is there stays valid
    parameters_changed ///< read parameters() anew
  };
  virtual ~Gate() = default;
  virtual Verdict pass(const Journal& journal, const Event& event) = 0;
  /// The parameters wanted now; read after parameters_changed.
  virtual CriteriaParameters wanted_parameters() const = 0;
};

/// Writes to a journal and asks the gate.
class Recorder {
 public:
  Recorder(Journal& journal, Gate& gate) : journal_(&journal), gate_(&gate) {}
  Gate::Verdict event(Event event);
  Gate::Verdict operation(Event event, Delta delta, const StepFigures& figures);
  Journal& journal() { return *journal_; }
  Gate& gate() { return *gate_; }

 private:
  Journal* journal_;
  Gate* gate_;
};

} // namespace isoscope
