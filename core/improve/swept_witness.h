// Whether a change of facets moves the surface across a witness point.
#pragma once

#include "base/geometry.h"

#include <optional>
#include <span>

namespace isoscope {

/// The first witness whose side changes when the facets `before` are replaced by `after`; both have the same
/// border.
std::optional<Vec3> swept_witness(std::span<const Vec3> witnesses, std::span<const Triangle3> before,
                                  std::span<const Triangle3> after);

} // namespace isoscope
