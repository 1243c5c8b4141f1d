// Separation: f has the sign of its side at every witness of the complement of Ω (core/README.md, N2 and N4).
#pragma once

#include "refine/context.h"

#include <vector>

namespace isoscope {

/// Asks f at every witness; where the sign is wrong the witness becomes a vertex.
class WitnessCondition {
 public:
  explicit WitnessCondition(RefinementContext& context) : context_(context) {}
  Turn turn();
  /// As the run that is followed found it: the witness at this point cannot become a vertex.
  void give_up(Vec3 point);
  /// Whether every witness of a region has its sign now.
  bool holds();

 private:
  /// Where a witness was found last, so that it is only looked for again when that place changed.
  struct Place {
    TetId tet;
    std::uint32_t generation = 0;
    bool good = false;
    bool given_up = false;
  };
  RefinementContext& context_;
  std::vector<Place> places_; ///< by witness

  std::size_t count() const;
  /// The way into thin parts first, then the witnesses.
  const Witness& witness(std::size_t i) const;
  bool good(std::size_t i);
};

} // namespace isoscope
