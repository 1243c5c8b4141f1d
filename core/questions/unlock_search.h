// Which neighbouring collapse would make a collapse possible that is not (§2.4.4, Figure 13).
#pragma once

#include "questions/edge_xray.h"

#include <functional>

namespace isoscope {

/// One neighbouring edge that was collapsed on a copy.
struct UnlockTrial {
  VertexId a, b; ///< a stays
  Vec3 from, to; ///< its ends
  EdgeKind kind = EdgeKind::other;
  Reason rejected = Reason::none; ///< why it cannot be collapsed itself; none: it can
  Vec3 target;                    ///< its own
  bool gone = false;              ///< the edge asked about vanished with it
  Reason then = Reason::none;     ///< what the edge asked about says after it; none: it can be collapsed
  Vec3 target_then;               ///< its target after it
  bool unlocks() const { return rejected == Reason::none && !gone && then == Reason::none; }
};

struct UnlockSearch {
  std::vector<UnlockTrial> trials; ///< those that unlock first, then by ids
  bool complete = false;           ///< it was not cancelled
  std::size_t count() const;       ///< how many unlock
};

/// Tries every edge between vertices of the star that the stages would collapse next to this one: those
/// between Z and Γ once Z is embedded, those of ∂Γ before. `progress` hears the fraction done and says
/// whether to go on. Nothing where T has no such edge.
std::optional<UnlockSearch> search_unlocks(const StateSnapshot& state, const EdgeQuestion& question,
                                           const XrayContext& context,
                                           const std::function<bool(double)>& progress);

} // namespace isoscope
