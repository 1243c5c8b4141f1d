// What Z has beyond the rim of open surfaces, as far as it closes holes (§4.1).
#pragma once

#include "mesh/zero_curves.h"
#include "tolerance/tolerance_volume.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// Which holes are to be filled.
struct HoleChoice {
  enum class Rule : std::uint8_t { none, flat, all, listed };
  /// Loops that reach no farther from a plane than this share of their diameter count as flat.
  static constexpr double flat = 0.1;
  Rule rule = Rule::none;
  std::vector<std::uint32_t> loops; ///< where they are listed, ascending: numbers of Rim::loops()
  bool wants(std::uint32_t loop, const RimLoop& description) const;
  friend bool operator==(const HoleChoice&, const HoleChoice&) = default;
};

/// A connected part of what was dropped from Z.
struct Cap {
  std::vector<DroppedFacet> facets; ///< ascending
  std::vector<std::uint32_t> loops; ///< of the rim along which it meets Z, ascending
  long euler_characteristic = 0;
  /// Whether it is a disc: then it fills the hole that its one loop surrounds, and nothing else changes.
  bool fills() const { return loops.size() == 1 && euler_characteristic == 1; }
};

/// The parts in the order of their first facets.
std::vector<Cap> find_caps(const Complex& complex, const ToleranceVolume& volume);
/// "loops 1, 3" of numbers of Rim::loops(), as the text of a filling names them, counted from one, and back.
std::string loops_in_words(const std::vector<std::uint32_t>& loops);
std::vector<std::uint32_t> loops_in_words(std::string_view words);
/// What makes facets part of Z that were dropped. Ascending, each once.
Delta fill_delta(const Complex& complex, const std::vector<DroppedFacet>& facets);

} // namespace isoscope
