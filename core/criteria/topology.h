// Condition 4: components and Euler characteristic of Z against what is expected (§2.3, §3).
#pragma once

#include "mesh/zero_set.h"
#include "tolerance/tolerance_volume.h"

#include <optional>
#include <string>

namespace isoscope {

/// What to ask of Z where Ω is no thickening of a surface (§1.2).
enum class TopologyMode : std::uint8_t {
  keep,    ///< the input's own topology
  separate ///< only that Z separates the sides; any genus
};

/// What Z should look like. Where a number is absent it is not judged.
struct ExpectedTopology {
  std::optional<long> euler_characteristic;
  std::optional<std::size_t> components;
  /// Closed curves of the border, once Z is cut along the rim; absent for closed surfaces, which have none.
  std::optional<std::size_t> boundary_loops;
  /// In words: why no number of loops is given for open surfaces, as "the 2 of the rim …".
  std::string loops_untold;
  std::string nothing; ///< why no number is given, where one was asked for
  /// In words: "both boundaries of Ω", "the input", "the boundary of smaller genus", "all boundaries of Ω, by
  /// half".
  std::string source;
  /// Whether a surface inside Ω is known to have it. Where not, refinement aims at it, but a result without
  /// it is no failure: Ω is no thickening and the input no embedded surface.
  bool required = true;
  /// Whether parts that overlap or touch are to be one there, as Ω joins them; what counts as inside in Ω is
  /// then up to where it has its boundary, not to the input alone.
  bool joined = false;
  /// How far into Ω the offset of the outside reaches whose boundary was counted then; 0: none was.
  double reach = 0;
};
ExpectedTopology expected_topology(const ToleranceVolume& volume, TopologyMode mode);
/// What refinement may be asked for: nothing where there are open surfaces, along whose rim Z is not cut yet.
ExpectedTopology expected_before_the_cut(const ToleranceVolume& volume, const ExpectedTopology& expected);

/// Z against the expectation.
struct TopologyVerdict {
  long euler_characteristic = 0;
  std::size_t components = 0;
  std::size_t boundary_loops = 0;
  bool as_expected = false;
};
TopologyVerdict check_topology(const ZeroSet& zero_set, const ExpectedTopology& expected);

} // namespace isoscope
