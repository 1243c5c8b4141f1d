// What the improver tells: its committed changes of Z and its decisions with their reasons.
#pragma once

#include "base/geometry.h"
#include "journal/event.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isoscope {

/// One committed change of Z. Facet slots and vertex ids are stable through the whole run of the improver;
/// ids index the input mesh.
struct SurfaceChange {
  enum class Kind {
    collapse,   ///< a collapse without repair
    relaxation, ///< one sweep of relocations and flips over all of Z
    repair      ///< a collapse with repair of its neighbourhood
  };
  struct Facet {
    std::uint32_t slot;
    std::array<std::uint32_t, 3> v;
  };
  struct Move {
    std::uint32_t vertex;
    Vec3 before, after;
  };
  Kind kind = Kind::collapse;
  std::vector<Facet> removed, added; ///< ascending by slot; a facet with other corners is in both
  std::vector<Move> moves;           ///< ascending by vertex
  std::vector<std::uint32_t> killed_vertices;
};

/// What was decided on an edge (or on a sweep) and why. Lengths are absolute.
struct ImproverVerdict {
  enum class Reason {
    accepted,     ///< value: the largest sampled d of the changed facets, at most δ = limit
    distance,     ///< the largest sampled d (value) stays above what a certificate can accept (limit)
    certificate,  ///< d(witness) = value > δ = limit
    folded,       ///< a facet is turned away from the input's normals, or has no normal
    orientation,  ///< more failed tests of condition 3 (value) than before (limit)
    witness,      ///< a region's witness would change side
    intersection, ///< two facets would meet, one of them at `witness`
    connectivity, ///< a vertex would be left with fewer than three facets, or two edges would join the same
                  ///< ends
  };
  Reason reason = Reason::accepted;
  SurfaceChange::Kind kind = SurfaceChange::Kind::collapse;
  std::uint32_t a = 0, b = 0; ///< the edge; b is merged into a. Both 0 for a relaxation
  Vec3 target;                ///< where the merged vertex was put first
  double value = 0, limit = 0;
  Vec3 witness;
  double cost = 0; ///< largest sampled d of the merged vertex's star at its target
  std::vector<RepairSweep> sweeps;
  std::uint32_t moved = 0, flipped = 0;

  bool accepted() const { return reason == Reason::accepted; }
};

} // namespace isoscope
