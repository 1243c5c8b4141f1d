// What an algorithm sees of the journal: it records, and at each operation it may be held, stopped or given
// new parameters.
#pragma once

#include "journal/journal.h"
#include "journal/rehearsal.h"

#include <optional>

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

  /// The journal has the beginning of the run already, and from its event `next` on it is made once more:
  /// that goes to `scratch`, and nobody is asked. Behind the journal's last event all is as ever.
  void rehearse(Journal& scratch, std::size_t next);
  /// Null outside of a rehearsal.
  const Rehearsal* rehearsal() const { return rehearsal_ ? &*rehearsal_ : nullptr; }
  /// Something was made that the journal does not have: the run cannot go on from there.
  bool astray() const { return astray_; }
  void go_astray() { astray_ = true; }

 private:
  Gate::Verdict followed(const Event& made);

  Journal* journal_;
  Gate* gate_;
  Journal* kept_ = nullptr; ///< during a rehearsal: the one that has the beginning
  std::optional<Rehearsal> rehearsal_;
  bool astray_ = false;
};

} // namespace isoscope
