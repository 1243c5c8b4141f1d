// One decision of the algorithm with its reasons: the unit of the journal (architecture D1).
#pragma once

#include "base/geometry.h"
#include "base/ids.h"

#include <cstdint>
#include <string_view>

namespace isoscope {

/// The stages of a run, in the paper's order.
enum class Stage : std::uint8_t { setup, refinement, gamma, tessellation, zero_set, all, improve };

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
  stopped           ///< the run ended before its goal: cancelled or a limit; see Journal::text
};

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
  region_witness,      ///< the deepest point of a region
  medial_point,        ///< topology: a point of thin material or of a narrow tunnel
  crossing_simplex,    ///< topology: an edge or facet of one label that crosses the input
  tightened,           ///< topology: containment asked at a smaller δ
  no_sample_inside,    ///< exhausted: no sample strictly inside the circumscribed ball
  already_vertex,      ///< exhausted: the candidate is a vertex of T
  too_close,           ///< exhausted: the candidate is nearer to a vertex than the spacing bound
  budget,              ///< a limit of work was reached
  user                 ///< asked for by the user
};
constexpr int reason_count = 15;

/// A fixed-size record; numbers mean what `condition` says (ε against 1 − α, height against 2σ/α, d against δ
/// ...).
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
  VertexId vertex;        ///< the vertex it made
  Vec3 point;             ///< where it was inserted
  Vec3 witness;           ///< the point at which the violation was measured
  double value = 0;       ///< measured
  double limit = 0;       ///< what it had to keep; for topology checks: value = χ found, limit = χ expected
  std::uint32_t count = 0; ///< topology_check: components of Z found; exhausted: how many so far
  std::uint32_t text = 0;  ///< index into Journal::text, 0 none
  friend bool operator==(const Event&, const Event&) = default;
};

std::string_view name(Stage);
std::string_view name(EventKind);
std::string_view name(Condition);
std::string_view name(Reason);

} // namespace isoscope
