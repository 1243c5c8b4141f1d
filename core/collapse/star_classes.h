// Whether the samples of a star keep their class, asked for one target after another (sampled mode).
#pragma once

#include "collapse/target_search.h"
#include "journal/journal.h"
#include "mesh/edge_star.h"

#include <cstdint>
#include <vector>

namespace isoscope {

/// The samples of a star by label, in boxes of boxes. Samples with near ids lie near each other, mostly:
/// whole boxes pass at once where the bounds of f say so, and what is left is judged sample by sample, by
/// exact predicates where planes do not tell. Refers to the star.
class StarClasses {
 public:
  explicit StarClasses(const EdgeStar& star);

  /// Samples keep their class where both ends go to `target`, which lies inside the kernel: ε <= 1 − α where
  /// it held (§2.4.1), the tetrahedron of their own label once Z is embedded (§2.4.2). Names the sample of
  /// least id that does not.
  TargetVerdict check(Vec3 target, const CriteriaParameters& criteria) const;

 private:
  struct Node {
    Vec3 center, half;
  };
  struct Side {
    std::int8_t label = 0;
    std::vector<std::uint32_t> samples;    ///< places in the star's list, ascending
    std::vector<std::vector<Node>> levels; ///< from single leaves up to one box
  };
  struct Piece;
  class Search;

  const EdgeStar& star_;
  Box3 box_;
  std::vector<Side> sides_; ///< ascending by label
};

} // namespace isoscope
