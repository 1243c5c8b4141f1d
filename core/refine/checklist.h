// Which tetrahedra still have to be judged by a condition, which violate it and which are beyond help.
#pragma once

#include "base/ids.h"

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace isoscope {

/// The state of one condition over all tetrahedron slots. Everything comes out in ascending slot order.
class Checklist {
 public:
  enum class State : std::uint8_t {
    absent,    ///< not asked of this tetrahedron
    pending,   ///< to be judged
    good,      ///< holds
    violated,  ///< does not hold; a Steiner point may help
    exhausted, ///< does not hold and no candidate is left until the tetrahedron changes
    undecided  ///< could not be judged within the work allowed
  };

  /// The tetrahedron died, or is not asked any more.
  void forget(TetId t);
  /// To be judged anew.
  void add(TetId t);
  void clear();
  void set(TetId t, State state);
  State state(TetId t) const { return t.index() < states_.size() ? states_[t.index()] : State::absent; }

  /// The pending tetrahedra, ascending; they stay pending until set. Valid until the next change.
  const std::vector<TetId>& pending();
  /// The violated tetrahedron of the smallest slot, invalid when there is none.
  TetId first_violated() const { return violated_.empty() ? TetId() : *violated_.begin(); }
  std::size_t violated() const { return violated_.size(); }
  std::size_t exhausted() const { return exhausted_; }
  std::size_t undecided() const { return undecided_; }

 private:
  std::vector<State> states_;
  std::vector<TetId> pending_; ///< may hold slots that are not pending any more
  std::set<TetId> violated_;
  std::size_t exhausted_ = 0, undecided_ = 0;
};

} // namespace isoscope
