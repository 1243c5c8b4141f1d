// The figures of the further rounds.
#include "improve/further_rounds.h"

#include <algorithm>
#include <array>

namespace isoscope {
namespace {

/// More than all passes of the phases.
constexpr std::size_t first_pass = 0x10000;
constexpr std::size_t longest_wait = 32; ///< rounds

struct Amplitude {
  int rings;
  double flips_per_vertex; ///< so that a pass takes about as long as the collapses after it
  std::size_t least_flips;
  RepairOptions repair;
};
/// The first is that of the phases. On a sphere no flip stays with it once facets are even: a flipped edge is
/// 1.7 times as long.
constexpr std::array amplitudes{
    Amplitude{1, 2.5, 100, {.sweeps = 4, .certificates = 2}},
    Amplitude{2, 0.5, 20, {.sweeps = 8, .certificates = 3, .most_flip_excess = 2.5, .jointly = true}},
    Amplitude{4, 0.5, 20, {.sweeps = 12, .certificates = 3, .most_flip_excess = 5, .jointly = true}},
};
/// Of the tries: fewer flips that stay leave the surface nearly what it is.
constexpr double few = 0.02;

} // namespace

ShakeOptions FurtherRounds::flips(std::size_t vertices) const {
  const Amplitude& a = amplitudes[amplitude_];
  ShakeOptions options;
  options.pass = static_cast<std::uint32_t>(first_pass + round_);
  options.most_attempts =
      std::max(a.least_flips, static_cast<std::size_t>(a.flips_per_vertex * static_cast<double>(vertices)));
  options.repair = a.repair;
  options.rings = a.rings;
  return options;
}

bool FurtherRounds::end(const ShakeFigures& flips, bool changed) {
  const bool still = static_cast<double>(flips.flipped) <= few * static_cast<double>(flips.attempts);
  amplitude_ = still && amplitude_ + 1 < amplitudes.size() ? amplitude_ + 1 : 0;
  in_vain_ = changed || !flips.all_tried ? 0 : in_vain_ + 1;
  ++round_;
  return in_vain_ < amplitudes.size();
}

void FurtherRounds::wide_saved(std::size_t collapsed) {
  wait_ = collapsed > 0 ? 1 : std::min(2 * wait_, longest_wait);
  next_wide_ = round_ + wait_;
}

} // namespace isoscope
