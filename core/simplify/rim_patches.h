// The parts that a cut makes of Z: what is kept and what is dropped, joined across edges.
#pragma once

#include "base/ids.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace isoscope {

/// Corners ascending, so that edges come out sorted.
using RimFacet = std::array<VertexId, 3>;
using RimEdge = std::array<VertexId, 2>;
inline std::array<RimEdge, 3> rim_edges(const RimFacet& f) {
  return {{{f[0], f[1]}, {f[0], f[2]}, {f[1], f[2]}}};
}

struct RimPatch {
  bool kept = false;
  std::vector<std::uint32_t> facets; ///< numbers, ascending
  std::vector<RimEdge> border;       ///< towards facets of the other kind; ascending
};

/// The patches of a surface, ordered by their first facets. `facets`: sorted corners; `kept`: by facet.
std::vector<RimPatch> rim_patches(std::span<const RimFacet> facets, std::span<const std::uint8_t> kept);

/// The shortest way along edges of facets from one set of vertices to another, both ascending: its vertices
/// with both ends, those between being allowed. Empty where there is none up to a length.
std::vector<VertexId> shortest_way(std::span<const RimFacet> facets, std::span<const VertexId> from,
                                   std::span<const VertexId> to,
                                   const std::function<bool(VertexId)>& is_allowed,
                                   const std::function<double(VertexId, VertexId)>& length, double limit);

} // namespace isoscope
