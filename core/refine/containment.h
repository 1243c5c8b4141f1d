// Containment by certificate: every zero polygon is proven inside Ω, else a point outside becomes a vertex
// (algorithm notes §2).
#pragma once

#include "refine/context.h"
#include "tolerance/facet_certificate.h"

#include <optional>

namespace isoscope {

/// Replaces condition 2 in certified mode.
class ContainmentCondition {
 public:
  explicit ContainmentCondition(RefinementContext& context) : context_(context) {
    context.follow(checklist_);
  }
  Turn turn();
  /// Polygons that are not proven inside Ω, among those judged.
  std::size_t unproven() const {
    return checklist_.exhausted() + checklist_.violated() + checklist_.undecided();
  }

 private:
  /// A vertex that would push Z back into Ω.
  struct Candidate {
    Vec3 point;
    Reason reason = Reason::projected;
  };
  /// Where Z leaves Ω.
  struct Violation {
    Vec3 witness;
    ClosestPoint closest;
  };

  RefinementContext& context_;
  Checklist checklist_;

  void judge_pending();
  Checklist::State judge(TetId t) const;
  FacetVerdict::Kind certify(TetId t, Violation* violation) const;
  Turn mend(TetId t, const Violation& violation);
  Turn give_up(TetId t, Checklist::State state, Event event);
  /// The first that the spacing of vertices allows; vertices keep apart, so that there are finitely many.
  std::optional<Candidate> candidate(TetId t, const Violation& violation, int label) const;
  std::optional<Candidate> traced_candidate(TetId t, const Violation& violation, int label) const;
  bool has_room(Vec3 p, TetId t) const;
  std::optional<Vec3> first_boundary_point(Vec3 from, Vec3 to) const;
};

} // namespace isoscope
