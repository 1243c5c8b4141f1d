// Condition 4: Z gets the components and the Euler characteristic that are expected of it (§2.3, algorithm
// notes §2).
#pragma once

#include "criteria/topology.h"
#include "refine/context.h"

#include <optional>
#include <vector>

namespace isoscope {

/// The paper's rule: while the topology is wrong, refine the tetrahedron that carries Z with the largest
/// circumradius.
class TopologyCondition {
 public:
  TopologyCondition(RefinementContext& context, const ExpectedTopology& expected, std::size_t insertion_limit)
      : context_(context), expected_(expected), insertion_limit_(insertion_limit) {}
  Turn turn();
  /// Tries anew what it had given up.
  void reconsider() { given_up_ = false; }
  /// Z as it is now; cached until T changes.
  const TopologyVerdict& verdict();

 private:
  struct Candidate {
    TetId tet;
    std::uint32_t generation = 0;
    double radius = 0;
  };
  RefinementContext& context_;
  ExpectedTopology expected_;
  std::size_t insertion_limit_;
  std::optional<TopologyVerdict> verdict_;
  Step judged_at_ = 0;
  std::optional<Step> noted_at_;
  std::vector<Candidate> candidates_; ///< ascending by circumradius
  bool given_up_ = false;

  void note_check();
  void collect_candidates();
  Turn refine_largest();
};

} // namespace isoscope
