// Z component by component against the boundary components of Ω, with a loop around a handle (§2.3, condition
// 4; §3).
#pragma once

#include "mesh/shortest_loop.h"
#include "questions/snapshot.h"

#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// One boundary component of Ω beside the component of Z that runs along it.
struct BoundarySide {
  std::uint32_t boundary = 0; ///< index into Scene::boundary_components
  int label = +1;
  long euler_characteristic = 0;
  /// Absent where χ > 2: then it is several surfaces, no closed one has more than 2.
  std::optional<long> genus() const {
    if (euler_characteristic > 2) return std::nullopt;
    return (2 - euler_characteristic) / 2;
  }
  /// At least so many closed surfaces.
  long least_parts() const { return euler_characteristic > 2 ? (euler_characteristic + 1) / 2 : 1; }
};

struct ComponentReport {
  ZeroSet::Component counts;
  std::vector<BoundarySide> sides;
  /// What the boundaries beside it say; absent where they disagree, there is none, or rooms meet.
  std::optional<long> expected_genus;
  /// Of rooms: half the sum of those beside it.
  std::optional<long> expected_characteristic;
  bool as_expected() const {
    return expected_genus.value_or(counts.genus()) == counts.genus() &&
           expected_characteristic.value_or(counts.euler_characteristic()) == counts.euler_characteristic();
  }
  std::optional<SurfaceLoop> loop; ///< around or through a handle, where there is one
};

struct TopologyReport {
  TopologyVerdict verdict;
  ExpectedTopology expected;
  std::vector<ComponentReport> components; ///< as in ZeroSet::components
  bool thickening = true;                  ///< whether both boundaries of Ω agree
  std::string words;                       ///< one or two sentences: right, or what is wrong and where
  std::size_t wrong_components = 0;
};

/// `bases`: from how many vertices loops are looked for in each component.
TopologyReport report_topology(const StateSnapshot& state, const Scene& scene, std::size_t bases,
                               const RunControl& control);

} // namespace isoscope
