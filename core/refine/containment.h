// Containment by certificate: every zero polygon is proven inside Ω, else a point outside becomes a vertex
// (core/README.md, N2).
#pragma once

#include "refine/context.h"
#include "tolerance/facet_certificate.h"

#include <optional>

namespace isoscope {

/// Replaces condition 2 in certified mode.
class ContainmentCondition {
 public:
  explicit ContainmentCondition(RefinementContext& context);
  Turn turn();
  /// As the run that is followed found it: no vertex was found that would push Z back there.
  void give_up(TetId t) { checklist_.set(t, Checklist::State::exhausted); }
  /// Polygons that are not proven inside Ω, among those judged.
  std::size_t unproven() const {
    return checklist_.exhausted() + checklist_.violated() + checklist_.undecided();
  }
  /// A place that shows the input to be open: a region outside of Ω' is on both sides of it.
  std::optional<Vec3> open_at() const { return open_at_; }

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
  PieceJudge judge_; ///< empty where every piece of Z has to be inside Ω
  Checklist checklist_;
  std::optional<Vec3> open_at_;

  void judge_pending();
  Checklist::State judge(TetId t) const;
  FacetVerdict::Kind certify(TetId t, Violation* violation) const;
  Turn mend(TetId t, const Violation& violation);
  /// Where balls outside of Ω' of a tetrahedron's vertices with different labels overlap: no Z inside Ω
  /// passes between them.
  std::optional<Vec3> both_sides_meet(TetId t) const;
  /// Between two vertices of t that are on different sides: a place from which to both, along the edge, φ
  /// exceeds δ. Vertices stay, so that every Z from now on leaves Ω there.
  std::optional<Vec3> sides_joined_beyond(TetId t) const;
  Turn give_up(TetId t, Checklist::State state, Event event);
  /// The first that the spacing of vertices allows; vertices keep apart, so that there are finitely many.
  std::optional<Candidate> candidate(TetId t, const Violation& violation, int label) const;
  std::optional<Candidate> traced_candidate(TetId t, const Violation& violation, int label) const;
  bool has_room(Vec3 p, TetId t) const;
  /// φ(p) − δ'.
  double clearance(Vec3 p) const;
  /// Whether nothing of Ω' is between two places that are both outside of it.
  bool joined_outside(Vec3 p, Vec3 q) const;
  /// Whether a place outside of Ω, with the side that it is on, is joined to a vertex of t on another side:
  /// open surfaces have such places beyond a jagged rim, where nearest places jump from one face to the
  /// other.
  bool meets_other_side(TetId t, Vec3 p, int label) const;
  /// Whether a place outside of Ω' is on a side: round the rim of an open surface a way leads to the other.
  bool on_side(Vec3 p, int label) const;
  std::optional<Vec3> first_boundary_point(Vec3 from, Vec3 to) const;
};

} // namespace isoscope
