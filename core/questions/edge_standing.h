// Where an edge stands among the strata of Z, and which link conditions were judged for it (§2.4, §4.1,
// §4.2).
#pragma once

#include "criteria/link.h"
#include "mesh/edge_star.h"
#include "mesh/strata.h"
#include "mesh/zero_set.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

/// How a link condition came out.
enum class LinkAnswer : std::uint8_t { not_asked, holds, fails };

struct EdgeStanding {
  EdgeStrata strata;
  std::vector<std::int8_t> labels;              ///< of the sides around the edge, descending
  std::size_t kept = 0, dropped = 0;            ///< facets between sides at the edge: of Z, and cut off
  LinkAnswer in_t = LinkAnswer::not_asked;      ///< Lk(a) ∩ Lk(b) = Lk(ab) in T
  LinkAnswer in_sheets = LinkAnswer::not_asked; ///< in Z: both ends on it
  LinkAnswer on_curves = LinkAnswer::not_asked; ///< on its curves: both ends on them, and Z allows it
};

/// Of an edge whose link was judged.
EdgeStanding edge_standing(const EdgeStar& star, const LinkVerdict& link);

/// How many facets of Z have the edge, where its vertices are those of T or of a Z that has left it: 1 on the
/// border of Z, 2 in a sheet.
std::size_t facets_at(const ZeroSet& zero_set, VertexId a, VertexId b);

} // namespace isoscope
