// Which tetrahedra the filter and the clip let see, and in which role.
#include "scene/tet_visibility.h"

namespace isoscope {

TetRole tet_role(std::uint8_t flags, const TetFilter& filter, bool embedded) {
  if (embedded && filter.sides != TetFilter::Sides::both &&
      ((flags & tet_negative) != 0) != (filter.sides == TetFilter::Sides::inner))
    return TetRole::hidden;
  if ((flags & tet_box) && !filter.box) return TetRole::hidden;
  if ((flags & tet_violates_1) && filter.violate_1) return TetRole::violates_1;
  if ((flags & tet_violates_2) && filter.violate_2) return TetRole::violates_2;
  if ((flags & tet_violates_3) && filter.violate_3) return TetRole::violates_3;
  if ((flags & tet_changed) && filter.changed) return TetRole::changed;
  if (filter.all || ((flags & tet_heterogeneous) && filter.carry_zero_set)) return TetRole::plain;
  return TetRole::hidden;
}

} // namespace isoscope
