// Which step of one run belongs beside a step of another: what linked play heads ask.
#pragma once

#include "journal/journal.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace isoscope {

/// A stretch of operations in one stage; a stage that begins again right after itself goes on with its
/// stretch.
struct StageStretch {
  Stage stage = Stage::refinement;
  Step begin = 0, end = 0; ///< steps: the operations in [begin, end)
};
std::vector<StageStretch> stage_stretches(const Journal& journal);

/// Pairs stages of two runs in order: a stage that only one of them has stands alone. Indices into the lists.
using StagePair = std::pair<std::optional<std::size_t>, std::optional<std::size_t>>;
std::vector<StagePair> pair_stages(const std::vector<Stage>& a, const std::vector<Stage>& b);

/// Monotone in both directions. Up to the last common step a step belongs to itself; after it stages that
/// both runs have are paired, beginning with beginning and end with end, and in between a step belongs to the
/// one that is as far in its stage. Steps of a stage that the other run left out all belong to the step at
/// which it did.
class RunAlignment {
 public:
  struct Anchor {
    Step a = 0, b = 0; ///< steps that belong together
    friend bool operator==(const Anchor&, const Anchor&) = default;
  };

  RunAlignment() = default;
  /// `common`: operations that both runs have in common.
  RunAlignment(const std::vector<StageStretch>& a, Step steps_a, const std::vector<StageStretch>& b,
               Step steps_b, Step common);

  Step to_b(Step a) const;
  Step to_a(Step b) const;
  Step common() const { return common_; }
  /// Ascending in both; interpolated in between.
  const std::vector<Anchor>& anchors() const { return anchors_; }

 private:
  void add(Step a, Step b);
  Step map(Step from, Step Anchor::*key, Step Anchor::*value) const;
  std::vector<Anchor> anchors_{{}};
  Step common_ = 0;
};

} // namespace isoscope
