// One decision of the algorithm with its reasons: the unit of the journal (core/README.md, D1).
#pragma once

#include "base/geometry.h"
#include "base/ids.h"
#include "journal/vocabulary.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isoscope {

/// A fixed-size record; numbers mean what `condition` says (ε against 1 − α, height against 2σ/α, d against δ
/// ...). For collapses: `vertex` stays, `other` goes, `point` is the target, `value` the error of the order
/// (squared length), `count` the candidates that were judged. For rejections: `value` against `limit` as
/// `reason` says, at `witness`. For relaxations, repairs and shakes: `value` is the largest d over the facets
/// they touched, `limit` δ, `count` the vertices moved.
struct Event {
  EventKind kind = EventKind::warning;
  Stage stage = Stage::refinement;
  Condition condition = Condition::none;
  Reason reason = Reason::none;
  Step step =
      0; ///< operations applied before this event; an operation's own delta leads from step to step + 1
  bool operation = false; ///< has a delta
  TetId tet;              ///< the violating tetrahedron, alive at `step`
  SampleId sample;        ///< the violating sample (condition 1) or the inserted one
  VertexId vertex;        ///< the vertex it made, or the end of an edge that stays
  VertexId other;         ///< the other end of the edge
  Vec3 point;             ///< where it was inserted
  Vec3 witness;           ///< the point at which the violation was measured
  /// The facet of Z that an improver's change was refused for, in the corners it would have had: the one that
  /// stays above, leaves Ω, folds, or has the most failed tests of condition 3. Invalid where none is named.
  std::array<VertexId, 3> facet;
  double value = 0; ///< measured
  double limit = 0; ///< what it had to keep; for topology checks: value = χ found, limit = χ expected
  std::uint32_t count = 0;  ///< topology_check: components of Z found; exhausted: how many so far
  std::uint32_t text = 0;   ///< index into Journal::text, 0 none
  std::uint32_t detail = 0; ///< index into Journal::repairs, 0 none
  friend bool operator==(const Event&, const Event&) = default;
};

/// The step at which an event shows: the one it leads to, or the one it was decided at.
constexpr Step step_showing(const Event& event) {
  return event.step + (event.operation ? 1u : 0u);
}

/// One sweep of a collapse with repair: the inner level of a transaction.
struct RepairSweep {
  double largest_distance = 0;    ///< over the facets of the neighbourhood before it, absolute
  double distance_left = 0;       ///< the same after it
  Triangle3 worst_facet{};        ///< where that is, as it lay then; a rollback leaves it nowhere else
  double energy = 0;              ///< their summed energy
  std::uint32_t moved = 0;        ///< vertices relocated
  std::uint32_t flipped = 0;      ///< edges flipped
  std::uint32_t points_added = 0; ///< points at which the certificate failed, asked for from then on
  friend bool operator==(const RepairSweep&, const RepairSweep&) = default;
};
using RepairDetail = std::vector<RepairSweep>;

} // namespace isoscope
