// What the improver does once its phases are over: rounds without end, each by its number.
#pragma once

#include "improve/shake_round.h"

#include <cstddef>
#include <cstdint>

namespace isoscope {

/// The choices of the further rounds. Each begins with flips against the energy, whatever it becomes, and
/// tries to collapse what they have made cheap; some try the cheapest edges first with a wide neighbourhood,
/// whose vertices move all at once. They follow from the round's number and from what earlier ones of the
/// same run have saved, not from time.
class FurtherRounds {
 public:
  /// In δ, on the cost of the edges that are tried with wide neighbourhoods; their rings, sweeps and tries.
  static constexpr double wide_excess = 1.3;
  static constexpr int wide_rings = 4, wide_sweeps = 10;
  static constexpr std::size_t most_wide_tries = 60;

  explicit FurtherRounds(std::size_t first) : round_(first), next_wide_(first) {}
  /// The flips of the present round, on a surface with so many vertices. Their order is none that phases
  /// have. Their amplitude, how far they may exceed δ before their repair and how much of the surface that
  /// may move, is least at first.
  ShakeOptions flips(std::size_t vertices) const;
  /// Whether the round begins with wide neighbourhoods: after one in vain the next is twice as far.
  bool is_wide() const { return round_ >= next_wide_; }
  /// A wide beginning has collapsed so many edges.
  void wide_saved(std::size_t collapsed);
  /// Ends a round of these flips, in which the surface changed or not. Where hardly any flip stayed the
  /// amplitude grows, else it is the least again. False where nothing is left that could change anything:
  /// all edges were tried in vain with all amplitudes.
  bool end(const ShakeFigures& flips, bool changed);

 private:
  std::size_t round_, next_wide_, wait_ = 1, amplitude_ = 0;
  std::size_t in_vain_ = 0; ///< rounds in a row that tried every edge and changed nothing
};

} // namespace isoscope
