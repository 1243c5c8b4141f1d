// What was found out of edges of Z, and holds as long as nothing changes near them.
#pragma once

#include "improve/repair.h"

#include <cstdint>
#include <optional>
#include <unordered_map>

namespace isoscope {

/// A value by edge, with the number of commits when it was found.
template <class Value> class EdgeMemory {
 public:
  struct Known {
    std::uint32_t time = 0;
    Value value;
  };
  void clear() { known_.clear(); }
  void set(std::uint32_t a, std::uint32_t b, Known known) { known_[key(a, b)] = std::move(known); }
  /// Null where nothing is known. Edges are told by their ends in the order given.
  const Known* find(std::uint32_t a, std::uint32_t b) const {
    const auto at = known_.find(key(a, b));
    return at == known_.end() ? nullptr : &at->second;
  }

 private:
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32 | b; }
  std::unordered_map<std::uint64_t, Known> known_; ///< looked up only
};

/// Targets of collapses, which follow from the stars of an edge's ends; nothing where there is none.
class KnownCandidates {
 public:
  using Memory = EdgeMemory<std::optional<CollapseCandidate>>;
  /// Those that were placed with another effort are forgotten.
  Memory& of(const PlacementEffort& effort) {
    if (effort != effort_) memory_.clear();
    effort_ = effort;
    return memory_;
  }

 private:
  PlacementEffort effort_;
  Memory memory_;
};

/// Flips against the energy that failed, and whether they were tried at all: what becomes of them follows
/// from the facets that their repair may change and those next to these.
class FlipsInVain {
 public:
  struct Outcome {
    bool tried = false;
  };
  using Memory = EdgeMemory<Outcome>;
  /// Those that were repaired in another way are forgotten.
  Memory& of(const RepairOptions& repair, int rings) {
    if (repair != repair_ || rings != rings_) memory_.clear();
    repair_ = repair;
    rings_ = rings;
    return memory_;
  }

 private:
  RepairOptions repair_;
  int rings_ = -1;
  Memory memory_;
};

} // namespace isoscope
