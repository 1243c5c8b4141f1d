// Makes states of a small run from the core's parts, without the pipeline: what the scene's tests draw and
// pick.
#pragma once

#include "run/snapshot.h"
#include "tolerance/distance_grid.h"

#include <memory>

namespace isoscope::testing {

/// A scene, a state of its refinement and its distance grid.
struct Fabricated {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const StateSnapshot> state;
  std::shared_ptr<const DistanceGrid> grid;
};

/// Inserts samples of the largest error, `steps` of them at most, then describes the state. `delta` in
/// percent of the longest edge, `sigma` in parts of delta.
Fabricated fabricate(const TriangleSoup& soup, double delta, double sigma, std::size_t steps, int resolution);

/// One tetrahedron with the given values at its corners, its zero set and nothing else.
std::shared_ptr<const StateSnapshot> single_tetrahedron(const std::array<Vec3, 4>& p,
                                                        const std::array<double, 4>& f);

} // namespace isoscope::testing
