// One decision of the algorithm with its reasons: the unit of the journal (architecture D1).
#pragma once

#include "base/geometry.h"
#include "base/ids.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace isoscope {

/// The stages of a run, in the paper's order.
enum class Stage : std::uint8_t {
  setup,
  refinement,
  gamma,        ///< collapses of edges of ∂Γ (§2.4.1)
  tessellation, ///< Z into T (§2.4.2)
  zero_set,     ///< collapses of edges of Z (§2.4.3)
  all,          ///< collapses of edges between Z and Γ, and of Z again (§2.4.4)
  improve       ///< minimax placement, flips, collapses with repair (algorithm notes §6)
};
constexpr int stage_count = 7;

/// What kind of decision.
enum class EventKind : std::uint8_t {
  stage_begin,
  stage_end,
  insertion,        ///< a Steiner point entered T (an operation: it has a delta)
  relabel,          ///< F of vertices changed (an operation)
  exhausted,        ///< a tetrahedron violates a condition and no candidate is left for it
  topology_check,   ///< components and χ of Z against the expected ones
  parameter_change, ///< α, σ, shrink or conditions changed; an operation when S was replaced
  warning,          ///< something the user should know; see Journal::text
  stopped,          ///< the run ended before its goal: cancelled or a limit; see Journal::text
  collapse,         ///< an edge was collapsed (an operation)
  rejection,        ///< an edge could not be collapsed: `reason` is the first check that failed
  tessellation,     ///< Z went into T (an operation)
  departure,        ///< Z left T: its facets are free from here on (an operation)
  relaxation,       ///< a sweep of relocations and flips over Z (an operation)
  repair,           ///< an edge was collapsed and its neighbourhood repaired (an operation)
  shake             ///< edges of Z were flipped against the energy, with repair (an operation)
};
constexpr int event_kind_count = 16;

/// Which criterion asked for it (§2.3).
enum class Condition : std::uint8_t {
  none,
  classification, ///< condition 1: ε(s) <= 1 − α
  height,         ///< condition 2: height >= 2σ/α
  orientation,    ///< condition 3: shrunk copy classified well
  topology,       ///< condition 4: components and genus of Z
  containment,    ///< the facet certificate (algorithm notes §4), certified mode
  witness         ///< f has a region's sign at its deepest point
};
constexpr int condition_count = 7;

/// Why an event came out as it did, beyond its condition.
enum class Reason : std::uint8_t {
  none,
  largest_error,       ///< condition 1: the worst sample of the queue's top tetrahedron
  circumcenter_sample, ///< conditions 2, 3, 4: the sample nearest to the circumcentre
  projected,           ///< containment (a): the violating point projected to d = δ'
  toward_circumcenter, ///< containment (b): first point with d = δ' on the way to the circumcentre
  toward_opposite,     ///< containment (c): traced to a vertex of opposite label
  violating_point,     ///< containment (d): the violating point itself, where all others are taken
  region_witness,      ///< the deepest point of a region
  crossing_simplex,    ///< topology: an edge or facet of one label that crosses the input
  no_sample_inside,    ///< exhausted: no sample strictly inside the circumscribed ball
  already_vertex,      ///< exhausted: the candidate is a vertex of T
  too_close,           ///< exhausted: the candidate is nearer to a vertex than the spacing bound
  budget,              ///< a limit of work was reached
  user,                ///< asked for by the user
  // How the target of a collapse was found (§2.4).
  halfedge,          ///< one of the edge's ends
  sample_candidate,  ///< a sample of S inside the kernel (Figure 8)
  quadric_optimum,   ///< the least error inside the kernel
  lazy_constraints,  ///< the least error under half-spaces learnt from facets that left Ω
  kernel_sampling,   ///< a point drawn inside the kernel
  octree_search,     ///< the octree over the kernel, pruned by Ψ (Figures 9 and 12)
  minimax_placement, ///< the least largest distance (algorithm notes §6)
  // Why an edge was not collapsed.
  link_condition,      ///< Lk(a) ∩ Lk(b) ≠ Lk(ab) in T
  zero_link_condition, ///< the same in Z
  kernel_empty,        ///< no point sees the whole one-ring
  no_candidate,        ///< no candidate point lies in the kernel
  misclassified,       ///< a sample would change class (sampled mode)
  outside_tolerance,   ///< a facet of Z would leave Ω
  unproven,            ///< a facet could be proven neither inside nor outside
  normals,             ///< a facet or tetrahedron would violate condition 3 that did not before
  witness_side,        ///< the deepest point of a region would change side
  intersection,        ///< Z would intersect itself (without T)
  folded,              ///< a facet would turn over (without T)
  stays_above          ///< the repair did not bring every facet below δ
};
constexpr int reason_count = 33;

/// The first and the last reason for a collapse that was not made.
constexpr Reason first_rejection = Reason::link_condition;
constexpr Reason last_rejection = Reason::stays_above;

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

std::string_view name(Stage);
std::string_view name(EventKind);
std::string_view name(Condition);
std::string_view name(Reason);

} // namespace isoscope
