// The facet that a collapse of the improver left above δ, where the mesh that had it was forgotten again.
#pragma once

#include "journal/journal.h"
#include "questions/snapshot.h"

#include <optional>

namespace isoscope {

struct RefusedFacet {
  Triangle3 corners{};
  Vec3 farthest;       ///< its point of the largest distance that was found
  Vec3 closest;        ///< the point of the input next to it
  double distance = 0; ///< between both
};

/// Of a repair: the worst facet after a sweep, by default the last one. Of a collapse that was refused
/// without repair: the worst facet of the star that it would have made of `state`, the one before the event.
/// Nothing for other events.
std::optional<RefusedFacet> refused_facet(const Journal& journal, const Event& event,
                                          const StateSnapshot& state, const ToleranceField& input,
                                          std::optional<std::size_t> sweep = std::nullopt);

} // namespace isoscope
