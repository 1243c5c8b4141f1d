// The verdict on one edge: every check of a collapse with its number and its witness, never a bool
// (core/README.md, D1 and D2).
#pragma once

#include "criteria/invalid_region.h"
#include "criteria/kernel.h"
#include "criteria/link.h"
#include "journal/event.h"
#include "mesh/edge_star.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace isoscope {

/// The checks of a collapse, cheap ones first (§2.4).
enum class CollapseCheck : std::uint8_t {
  eligible,       ///< the edge is of the stage's kind
  link,           ///< Lk(a) ∩ Lk(b) = Lk(ab) in T
  zero_link,      ///< the same in Z and on its curves, for edges of Z
  kernel,         ///< some point sees the whole one-ring
  candidates,     ///< a target was found; what rejected the others is in `candidates`
  classification, ///< sampled mode: every sample keeps its class
  containment,    ///< certified mode: every facet of Z proven inside Ω
  normals,        ///< condition 3 is violated nowhere where it was not before
  witness,        ///< the deepest point of each region keeps its side
  border          ///< where the border of Z moves, it and the rim stay within δ of each other
};
constexpr std::size_t collapse_check_count = static_cast<std::size_t>(CollapseCheck::border) + 1;

struct CheckWords {
  CollapseCheck value;
  std::string_view name, title;
  std::string_view help; ///< how it is judged
  Reason reason;         ///< the rejection that it gives; containment may also be unproven
};
inline constexpr std::array check_table{
    CheckWords{CollapseCheck::eligible, "eligible", "eligible",
               "The edge is of the kind that the stage collapses: of ∂Γ, of Z, or between both. §2.4",
               Reason::ineligible},
    CheckWords{CollapseCheck::link, "link", "link condition in T",
               "Lk(a) ∩ Lk(b) = Lk(ab) in T, or the collapse would pinch it. Figure 6",
               Reason::link_condition},
    CheckWords{CollapseCheck::zero_link, "zero-link", "link condition in Z",
               "The same in Z and on its curves, for edges of Z. §2.4", Reason::zero_link_condition},
    CheckWords{
        CollapseCheck::kernel, "kernel", "kernel",
        "The points from which the whole one-ring is seen; its largest ball has this radius. Figures 7 "
        "and 11",
        Reason::kernel_empty},
    CheckWords{CollapseCheck::candidates, "candidates", "candidates",
               "Points of the kernel that were judged as targets until one passed every check. Figures 8, 9, "
               "11 and 12",
               Reason::no_candidate},
    CheckWords{CollapseCheck::classification, "classification", "classification",
               "Sampled mode: every sample keeps its class. §2.4.1", Reason::misclassified},
    CheckWords{CollapseCheck::containment, "containment", "containment in Ω",
               "Certified mode: every changed facet of Z is proven to keep d ≤ δ.",
               Reason::outside_tolerance},
    CheckWords{CollapseCheck::normals, "normals", "normals",
               "Condition 3 is violated nowhere where it was not before. §2.4", Reason::normals},
    CheckWords{
        CollapseCheck::witness, "witness", "region witnesses",
        "The deepest point of each region, and what holds Z in thin parts and at the open rim, stays on "
        "its side.",
        Reason::witness_side},
    CheckWords{
        CollapseCheck::border, "border", "border and rim",
        "Where the border of Z moves, it and the open rim of the input stay within δ of each other. §4.1",
        Reason::border_distance},
};
static_assert(is_complete(check_table, static_cast<int>(collapse_check_count)));
constexpr const CheckWords& words(CollapseCheck check) {
  return check_table[static_cast<std::size_t>(check)];
}
constexpr std::string_view name(CollapseCheck check) {
  return words(check).name;
}

/// One check's outcome; `value` against `limit` as the check says, at `witness`.
struct CheckVerdict {
  enum class State : std::uint8_t { skipped, passed, failed };
  State state = State::skipped;
  double value = 0, limit = 0;
  Vec3 witness;
  double seconds = 0; ///< that it took, with full detail; no part of the verdict
};

/// A target that was tried, in the order of trial.
struct CandidateRecord {
  Vec3 point;
  double cost = 0;                ///< error of the order at the point (squared length)
  Reason found_by = Reason::none; ///< which strategy proposed it
  Reason rejected = Reason::none; ///< none: it was taken
  double value = 0, limit = 0;    ///< of what rejected it
  Vec3 witness;
};

/// A cell of the octree over a kernel's box and what became of it, in the order of visit. The centre of a
/// cell that was not left out is a candidate.
struct OctreeCell {
  enum class Fate : std::uint8_t {
    split,          ///< its eight parts follow
    outside_kernel, ///< left out: no point of it is in the kernel
    invalid,        ///< left out: it lies inside one Ψ
    costlier,       ///< left out: no point of it has less error than a target already found
    last_level      ///< too deep to be split
  };
  Box3 box;
  Fate fate = Fate::split;
};

/// Everything there is to say about collapsing one edge.
struct CollapseAttempt {
  VertexId a, b; ///< a stays
  EdgeKind kind = EdgeKind::other;
  /// Those behind `candidates` speak of the target, and where none passed of the candidate of least error.
  std::array<CheckVerdict, collapse_check_count> checks;
  Reason rejected = Reason::none; ///< the first check that failed; none: the collapse is possible
  Reason found_by = Reason::none; ///< which strategy found the target
  Vec3 target;                    ///< meaningful when not rejected
  double cost = 0;                ///< error at the target
  double unconstrained_cost = 0;  ///< error at the quadric's own optimum: what the constraints cost
  Vec3 optimum;                   ///< that optimum
  std::uint32_t tried = 0;        ///< candidates judged
  // Filled when asked for (EvaluationDetail::full).
  LinkVerdict link;
  std::optional<Kernel> kernel;
  std::vector<CandidateRecord> candidates;
  std::vector<OctreeCell> cells;              ///< of the octree strategy
  std::vector<InvalidRegion> invalid_regions; ///< Ψ that the search met

  bool possible() const { return rejected == Reason::none; }
  /// The check whose numbers the journal keeps; null where every one passed.
  const CheckVerdict* first_failed() const {
    const auto found = std::find_if(checks.begin(), checks.end(), [](const CheckVerdict& c) {
      return c.state == CheckVerdict::State::failed;
    });
    return found != checks.end() ? &*found : nullptr;
  }
  const CheckVerdict& check(CollapseCheck c) const { return checks[static_cast<std::size_t>(c)]; }
  CheckVerdict& check(CollapseCheck c) { return checks[static_cast<std::size_t>(c)]; }
};

/// How much of the record to fill.
enum class EvaluationDetail : std::uint8_t {
  decision, ///< stop at the first check that fails: what the algorithm needs
  full      ///< every check, every candidate, the kernel: what a person asks for
};

} // namespace isoscope
