// Everything there is to say about collapsing one edge at one step: what a person asks of an edge, answered
// by the evaluator that the run itself asks (core/README.md, D2).
#pragma once

#include "collapse/collapse_evaluator.h"
#include "criteria/nearest_sample.h"
#include "questions/snapshot.h"

#include <array>
#include <optional>

namespace isoscope {

/// Which targets are looked for.
enum class XrayTarget : std::uint8_t {
  automatic, ///< as the stage of the edge's kind does it; as the event did it, where there is one
  halfedge,  ///< the ends of the edge
  general,   ///< the search of the parameters
  octree     ///< the paper's search, whatever the parameters say
};

/// An edge to be looked at.
struct EdgeQuestion {
  VertexId a, b;
  std::optional<std::uint32_t> event; ///< a collapse or a rejection of it: its moment is judged
  XrayTarget target = XrayTarget::automatic;
  friend bool operator==(const EdgeQuestion&, const EdgeQuestion&) = default;
};

/// What an answer depends on besides the state; all of it immutable.
struct XrayContext {
  const Scene& scene;
  const Journal& journal;
  const RunParameters& parameters;
  const NearestSample* nearest = nullptr;       ///< of the state's samples; null: condition 3 is not judged
  std::optional<CriteriaParameters> criteria{}; ///< instead of those in force at the step
};

/// The answer.
struct EdgeXray {
  EdgeStar star;
  bool before = false; ///< judged on the state before the operation that led to the step
  bool halfedge = false;
  CollapseSettings settings; ///< that it was judged by
  CriteriaParameters criteria;
  CollapseAttempt attempt;
  KernelPolyhedron kernel;
  /// A Ψ within the kernel; from which source on its faces stand for the ball.
  struct Invalid {
    KernelPolyhedron shape;
    std::size_t ball_from = 0;
  };
  std::vector<Invalid> invalid; ///< the largest Ψ that the search met, by descending volume
  /// Whether what was left out could be left out: centres of cells inside Ψ and of Ψ themselves are judged,
  /// and the errors at the centres of cells that were too costly.
  struct Pruning {
    std::uint32_t cells = 0;                               ///< left out for Ψ
    std::uint32_t cells_judged = 0;                        ///< of them: centre in the kernel, the first 160
    std::uint32_t regions_judged = 0;                      ///< Ψ whose middle is in the kernel
    std::uint32_t costlier_judged = 0, costlier_wrong = 0; ///< centres with less error than the target
    std::vector<Vec3> wrong;                               ///< judged points that would have been accepted
  };
  Pruning pruning;
  /// How many candidates each reason rejected; Reason::none: taken.
  std::array<std::uint32_t, reason_count> candidates{};
  /// Where an event was asked about, and no other search than the stage's: whether the journal says the same,
  /// numbers and all.
  std::optional<bool> agrees;
};

/// The event that speaks of an edge at the step shown: the operation that led there, else a rejection between
/// it and the next one.
std::optional<std::uint32_t> edge_event(const Journal& journal, Step step, VertexId a, VertexId b);

/// Where to look for what a check says: its witness, the offending simplices, the middle of the kernel;
/// nothing where there is no such place. `attempt` is that of the X-ray or of a target that was studied.
std::optional<Vec3> witness_of(const EdgeXray& xray, const CollapseAttempt& attempt, CollapseCheck check);

/// Judges the edge on the state. Nothing where T has no such edge: it is not there at this step, or Z has
/// left T.
std::optional<EdgeXray> edge_xray(const StateSnapshot& state, const EdgeQuestion& question,
                                  const XrayContext& context);

} // namespace isoscope
