// Condition 4: Z gets the components and the Euler characteristic that are expected of it (§2.3, algorithm
// notes §2).
#pragma once

#include "criteria/topology.h"
#include "refine/context.h"
#include "refine/misclassified_points.h"
#include "refine/offset_search.h"
#include "refine/refinement.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace isoscope {

/// Mends Z while its topology is wrong. Where the input tells the side of any point (closed, free of
/// self-intersections), points that f has on the wrong side go in, deepest first. In sampled mode the paper's
/// rule comes before: refine the tetrahedron that carries Z with the largest circumradius. Z of an open
/// surface is cut on trial, and points go in by sides near to it.
class TopologyCondition {
 public:
  TopologyCondition(RefinementContext& context, const ExpectedTopology& expected, std::size_t insertion_limit,
                    TrialCut trial)
      : context_(context), expected_(expected), insertion_limit_(insertion_limit), trial_(std::move(trial)) {
    reconsider();
  }
  Turn turn();
  /// Whether points on the wrong side are going in: condition 3, which asks samples, has to wait until they
  /// are through.
  bool mending() const { return mending_; }
  /// What is expected, in words: "χ = 0 with 1 component (from the input)".
  std::string expectation() const;
  /// Tries anew what it had given up.
  void reconsider();
  /// Z as it is now, or as a cut would leave it; cached until T changes.
  const TopologyVerdict& verdict();

 private:
  /// What is tried, in this order.
  enum class Phase { circumradii, contacts, offset, summits, edges, facets, basins, given_up };
  struct Candidate {
    TetId tet;
    std::uint32_t generation = 0;
    double radius = 0;
  };
  RefinementContext& context_;
  ExpectedTopology expected_;
  std::size_t insertion_limit_;
  TrialCut trial_; ///< of an open surface
  std::optional<TopologyVerdict> verdict_;
  Step judged_at_ = 0;
  std::optional<Step> noted_at_;
  Phase phase_ = Phase::edges;
  std::vector<Candidate> candidates_;      ///< ascending by circumradius
  std::vector<MisclassifiedPoint> points_; ///< shallowest first: taken from the back
  /// Of the input, highest first; found when edges and facets did not help, as for handles within tetrahedra.
  std::optional<std::vector<MisclassifiedPoint>> summits_;
  bool mending_ = false;
  double level_ = 0; ///< summits lower than this wait
  /// Where parts are to be joined, or rooms touch themselves; found when they are needed.
  std::optional<std::vector<MisclassifiedPoint>> contacts_;
  MisclassifiedSearch<2> edge_search_;
  MisclassifiedSearch<3> facet_search_;
  OffsetSearch offset_search_;
  std::vector<VertexId> turned_; ///< ascending
  double contact_spacing_ = 0;   ///< of these, in units of δ'
  bool fruitful_ = false;        ///< a point went in since the present phase last looked for points

  void note_check();
  /// Whether Z has what is expected; not asked between points that go in together where that takes a cut.
  bool is_right();
  bool sides_known() const { return context_.volume().input().sides_known(); }
  /// Whether there are places whose side is told.
  bool searchable() const { return sides_known() || trial_ || !context_.volume().basins().empty(); }
  /// Insertions that the paper's rule may ask for.
  std::size_t circumradius_limit() const;
  void enter(Phase phase);
  /// The first phase that looks for points.
  Phase first_search() const {
    if (context_.volume().has_rooms()) return Phase::contacts;
    if (!sides_known() && !trial_) return Phase::basins;
    return expected_.joined ? Phase::contacts : Phase::edges;
  }
  /// Where Z is right.
  Turn settle();
  Turn mend();
  /// Where Z is right but for spheres too many: those around vertices that nothing asks for go.
  bool turn_pockets();
  void advance();
  void lower_level();
  void leave_contacts();
  bool levels_left() const;
  /// The last phase: of the input's thin places, or nothing.
  void try_summits();
  void collect_points();
  bool insert_next_point();
  bool insert_point(const MisclassifiedPoint& candidate);
  bool misclassified(Vec3 p, int label, TetId t) const;
  void collect_candidates();
  bool refine_largest();
  Event event(Reason reason) const;
};

} // namespace isoscope
