// Condition 2: the height of a tetrahedron that carries Z (§2.3, Figure 5).
#pragma once

#include "base/geometry.h"
#include "base/labels.h"

#include <array>
#include <cstdint>

namespace isoscope {

/// The two supporting primitives and their distance.
struct Height {
  enum class Split : std::uint8_t { none, one_three, two_two };
  Split split = Split::none;
  double value =
      0; ///< distance between the supporting point/plane (1–3) or lines (2–2); equals 2/|∇f| for F = ±1
  /// Local indices: the apex first (1–3), or the positive edge then the negative edge (2–2).
  std::array<std::uint8_t, 4> order{0, 1, 2, 3};
};

/// Height of a tetrahedron of several labels: the least of those between one label and the rest; `none` when
/// homogeneous.
Height tetrahedron_height(const std::array<Vec3, 4>& p, const std::array<double, 4>& values,
                          const TetLabels& labels);
/// The same with values of both signs.
Height tetrahedron_height(const std::array<Vec3, 4>& p, const std::array<double, 4>& f);

} // namespace isoscope
