// What a run that is followed has decided already: one that repeats it takes the decisions from there.
#pragma once

#include "journal/journal.h"

namespace isoscope {

/// A place in a journal that moves on as each of its events is made once more.
class Rehearsal {
 public:
  /// Begins with the event `next`; `followed` must outlive it and not grow.
  Rehearsal(const Journal& followed, std::size_t next);
  const Journal& followed() const { return *followed_; }
  bool over() const { return next_ >= followed_->events().size(); }
  /// How many events there have been before.
  std::size_t place() const { return next_; }

  // Of the next event, as long as there is one.
  Event event() const { return followed_->events()[next_]; }
  /// An operation's.
  Delta delta() const { return followed_->operations()[event().step].delta(); }
  double seconds() const { return followed_->operations()[event().step].figures.seconds; }
  /// Of a change of parameters: those in force from then on.
  CriteriaParameters criteria() const;

  /// Moves on where an event says what the next one does; texts and the number of its step may be others.
  bool advance(const Event& made);

 private:
  const Journal* followed_;
  std::size_t next_;
};

/// The parameters in force when an event of a journal was made.
CriteriaParameters criteria_before(const Journal& journal, std::size_t event);

} // namespace isoscope
