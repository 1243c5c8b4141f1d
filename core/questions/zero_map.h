// A number on every place of Z at a step: distance, deviation of normals, valence, age.
#pragma once

#include "base/run_control.h"
#include "questions/snapshot.h"
#include "questions/zero_map_kind.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

struct ZeroMap {
  ZeroMapKind kind = ZeroMapKind::none;
  /// A part of a polygon on which the value is one.
  struct Piece {
    Triangle3 corners;
    float value = 0;
    std::uint8_t edges = 0; ///< bit i: the edge opposite corner i is one of the polygon's
  };
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> begin; ///< of the pieces of each polygon; one more at the end
  float low = 0, high = 1;          ///< what the colours reach from and to
  float least = 0, largest = 0;     ///< of the values
  float mean = 0;                   ///< over the area
  std::optional<float> limit;       ///< that the values should keep
};

/// Measured on pieces of each facet; distances and angles where they are, valence around each vertex, age on
/// whole facets. Angles are those to the closest input triangle as a plane, in [0°, 90°], as the input need
/// not be oriented. Nothing where it makes no sense, as angles without a surface, or once it is cancelled.
std::optional<ZeroMap> zero_map(const StateSnapshot& state, const Scene& scene, const Journal& journal,
                                ZeroMapKind kind, const RunControl& control = {});

} // namespace isoscope
