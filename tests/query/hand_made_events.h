// A short journal by hand whose every event is known.
#pragma once

#include "journal/journal.h"

#include <memory>

namespace isoscope::test {

/// 0 stage begins (refinement) · 1 insertion of vertex 8 for condition 2 at (1, 0, 0), height 0.5 δ after it
/// · 2 insertion of vertex 9 for condition 1 · 3 stage ends · 4 stage begins (zero-set) · 5 rejection of edge
/// (3, 9), kernel-empty, 2 against 1 · 6 rejection of edge (3, 8), normals · 7 collapse of edge (8, 9) by
/// halfedge · 8 rejection of edge (9, 3), kernel-empty · 9 stage ends. δ = 2, σ = 0.5, α = 0.2.
std::shared_ptr<Journal> hand_made_events();

} // namespace isoscope::test
