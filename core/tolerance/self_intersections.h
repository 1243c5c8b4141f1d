// Which facets of a mesh meet where they should not, by exact predicates.
#pragma once

#include "base/geometry.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace isoscope {

using FacetPair = std::pair<std::uint32_t, std::uint32_t>;

/// Pairs of facets (first < second, ascending) that meet in more than the vertices and edges they share by
/// their indices; facets that share an edge do where one lies folded onto the other, and a facet without an
/// area meets itself. Ends with the first `most` pairs. Nothing where stop(), which is asked all the time,
/// became true.
std::optional<std::vector<FacetPair>>
self_intersections(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> facets,
                   const std::function<bool()>& stop,
                   std::size_t most = std::numeric_limits<std::size_t>::max());

} // namespace isoscope
