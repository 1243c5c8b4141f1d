// A first coarsening of Z where its facets are much smaller than δ: every step is proven from its
// surroundings alone, without a question of the input (core/README.md, N10).
#pragma once

#include "base/run_control.h"
#include "improve/change_box.h"
#include "improve/surface_collapses.h"
#include "input/triangle_soup.h"
#include "tolerance/field.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace isoscope {

struct ThinningGround {
  const ToleranceField& field; ///< the distance to the input
  double delta = 0;
  std::span<const Vec3> kept;   ///< points that are to stay on their side of Z
  std::optional<ChangeBox> box; ///< as in ImproverGround
};

/// What is left of a mesh, by what it was: ascending.
struct ThinnedMesh {
  TriangleMesh mesh;
  std::vector<std::uint32_t> vertices, facets;
  bool stopped = false; ///< by the observer
};

/// Merges vertices into neighbours, which stay where they are, as long as edges stay shorter than about δ.
/// `mesh` is part of a closed surface without intersections that bounds what is on its back; so is the
/// result, all of which that has changed is within δ of the input, and no region deeper than δ changes side,
/// nor does a kept point. The observer is told of each change in the ids of `mesh`. The result depends on the
/// arguments alone; once cancelled it is of no use.
ThinnedMesh thin(const TriangleMesh& mesh, const ThinningGround& ground, const RunControl& control,
                 ImproverObserver& observer);

} // namespace isoscope
