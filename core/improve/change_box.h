// The part of space in which Z may change while it is improved piece by piece.
#pragma once

#include "base/geometry.h"

namespace isoscope {

/// A half-open box. Facets with all corners in it may change and stay in it; as it is convex, they meet no
/// facet of another box that does not overlap this one.
struct ChangeBox {
  Vec3 lo, hi;
  bool holds(Vec3 p) const {
    return p.x >= lo.x && p.x < hi.x && p.y >= lo.y && p.y < hi.y && p.z >= lo.z && p.z < hi.z;
  }
};

} // namespace isoscope
