// What a wall of the input bounds: the inside against the outside, or only one side of both.
#pragma once

#include "tolerance/tolerance_volume.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace isoscope {

/// What is on both sides of a piece of the input.
enum class Wall : std::uint8_t {
  outer, ///< the inside on one of them, outside on the other: a mesh has to be near
  inner, ///< the same on both, as where closed parts overlap or touch, or sides are not sure
  /// another part stands within 2δ' in front of it or leaves no room for a ball of radius δ' on it: Ω closes
  /// the gap
  of_closed_gap
};

struct WallVerdict {
  Wall kind = Wall::outer;
  int outward =
      +1; ///< of walls that are not inner: +1 where the normal that was given points outside, else -1

  /// Whether a mesh has to be near because of the side of this label: no inner wall asks for that, nor the
  /// outside in a gap that Ω closes.
  bool bounds(int label) const { return kind == Wall::outer || (label < 0 && kind == Wall::of_closed_gap); }
};

/// Judges the walls of one input; of soups where many rays agree. Const and thread-safe; the volume must
/// outlive it.
class InputWalls {
 public:
  explicit InputWalls(const ToleranceVolume& volume);

  /// Of the wall at p, a point of triangle `own`, by what one comes to along `normal` (a unit vector) and
  /// against it.
  WallVerdict judge(TriangleId own, Vec3 p, Vec3 normal) const;
  /// Whether a piece of a triangle lies within 2δ' of another connected part of the input.
  bool near_another_part(TriangleId own, const Triangle3& piece) const {
    return near_another_part(own, piece, gap_);
  }
  /// The same within another distance.
  bool near_another_part(TriangleId own, const Triangle3& piece, double within) const;

 private:
  bool is_of_pocket(Vec3 p, Vec3 out, double width) const;
  using Nearest = std::function<Vec3(Vec3)>;
  Nearest nearest() const;
  bool has_room_near(Vec3 center, const Nearest& nearest) const;
  bool is_plugged(TriangleId own, Vec3 before) const;
  bool is_closed_by_another(TriangleId own, Vec3 p, Vec3 out, double way) const;

  const ToleranceVolume& volume_;
  double gap_;
  std::vector<std::uint32_t> part_; ///< by triangle; none where there is one
};

} // namespace isoscope
