// Which points of walls and gaps are to be held so that Z stays near to all of the input.
#pragma once

#include "base/run_control.h"
#include "tolerance/closest_point.h"
#include "tolerance/sample_grid.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace isoscope {

/// Goes over a closed input, whose triangles are turned outwards, piece by piece; what is known of one piece
/// serves the next. Where a place has a point of each side within a distance it is that near to Z, as Z
/// passes between them.
class HeldPoints {
 public:
  /// `origin`: somewhere near to the input; `cover`, absolute: how far Z may be, at least 2 δ.
  HeldPoints(Vec3 origin, double delta, double cover);

  /// How far from a place all of the input is asked for.
  double reach() const { return near_ + 2 * delta_; }
  /// Looks at the parts of triangles whose middles are wanted: where no point beyond δ is found within reach
  /// on a side, and none is held, the deepest that is found is held. Of no use once the control is cancelled.
  void look(const ClosestPointIndex& piece, const std::function<bool(Vec3)>& wanted,
            const RunControl& control);
  const std::vector<Vec3>& held() const { return held_; }

 private:
  /// Points, asked for by distance; by one thread.
  class Places {
   public:
    Places(Vec3 origin, double radius) : grid_(origin, radius) {}
    void add(Vec3 p);
    bool any_within(Vec3 p, double radius) const;

   private:
    SampleGrid grid_;
    std::vector<Vec3> points_;
    mutable std::uint32_t last_ = 0; ///< that was found
    mutable std::vector<std::uint32_t> found_;
  };
  struct Side {
    double sign;   ///< +1 in front of triangles
    Places deep;   ///< beyond δ, and held ones
    Places looked; ///< places of the input that have no such
  };
  /// A place of the input without a point beyond δ near to it, and the deepest point there.
  struct Bare {
    Vec3 place, deepest;
    double depth;
  };

  void look_at(const ClosestPointIndex& piece, const Triangle3& triangle, TriangleId id,
               const std::function<bool(Vec3)>& wanted, Side& side, std::vector<Bare>& bare) const;
  Bare climb(const ClosestPointIndex& piece, Vec3 place, Vec3 way, TriangleId id) const;

  double delta_, near_;
  std::array<Side, 2> sides_;
  std::vector<Vec3> held_;
};

} // namespace isoscope
