// What the improver tells: its committed changes of Z and its decisions with their reasons.
#pragma once

#include "journal/refusal.h"
#include "mesh/complex.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

/// One committed change of Z. Facet slots and vertex ids are stable through the whole run of the improver;
/// ids index the input mesh.
struct SurfaceChange {
  struct Facet {
    std::uint32_t slot;
    std::array<std::uint32_t, 3> v;
  };
  struct Move {
    std::uint32_t vertex;
    Vec3 before, after;
  };
  EventKind kind = EventKind::collapse; ///< collapse, relaxation, repair or shake
  std::vector<Facet> removed, added;    ///< ascending by slot; a facet with other corners is in both
  std::vector<Move> moves;              ///< ascending by vertex
  std::vector<std::uint32_t> killed_vertices;
  Delta tetrahedra; ///< the same change in T, where Z is improved inside it; else empty
};

/// What was decided on an edge (or on a sweep) and why. Lengths are absolute. Accepted: `value` is the
/// largest sampled d of the changed facets, or a bound of it where one end was the target, at most δ =
/// `limit`. Refused:
///   stays_above          the largest sampled d (value) stays above what a certificate can accept (limit)
///   outside_tolerance    d(witness) = value > δ = limit
///   folded               a facet is turned away from the input's normals, or has no normal
///   normals              more failed tests of condition 3 (value) than before (limit)
///   witness_side         a region's witness would change side
///   intersection         two facets would meet, one of them at `witness`
///   border_distance      the border and the input's rim would be value > δ = limit apart at `witness`
///   zero_link_condition  a vertex would be left with fewer than three facets, or two edges would join the
///   same
///                        ends
struct ImproverVerdict : Refusal {
  EventKind kind = EventKind::collapse; ///< collapse, relaxation, repair or shake
  std::uint32_t a = 0, b = 0;           ///< the edge; b is merged into a. Both 0 for a relaxation or a shake
  Vec3 target;                          ///< where the merged vertex was put first
  Reason placed = Reason::minimax_placement; ///< how that was found
  double cost = 0;                           ///< largest sampled d of the merged vertex's star at its target
  std::optional<std::array<std::uint32_t, 3>> facet; ///< refused: the facet that the reason speaks of
  std::vector<RepairSweep> sweeps;
  std::uint32_t moved = 0, flipped = 0;
};

} // namespace isoscope
