// Compares solid angles: old and new facets bound a closed chain whose winding around a witness must be zero.
#include "improve/swept_witness.h"

#include "base/solid_angle.h"

namespace isoscope {

std::optional<Vec3> swept_witness(std::span<const Vec3> witnesses, std::span<const Triangle3> before,
                                  std::span<const Triangle3> after) {
  Box3 box;
  for (const auto facets : {before, after})
    for (const Triangle3& t : facets)
      for (const Vec3 p : t) box.add(p);
  for (const Vec3 w : witnesses) {
    bool inside = true;
    for (int k = 0; k < 3; ++k) inside = inside && w[k] >= box.lo[k] && w[k] <= box.hi[k];
    if (!inside) continue;
    SolidAngleSum change;
    for (const Triangle3& t : before) change.add(w, t, -1);
    for (const Triangle3& t : after) change.add(w, t);
    if (std::abs(change.winding()) > 0.25) return w;
  }
  return std::nullopt;
}

} // namespace isoscope
