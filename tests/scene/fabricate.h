// Makes states of a small run from the core's parts, without the pipeline: what the scene's tests draw and
// pick.
#pragma once

#include "questions/snapshot.h"
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

/// The same over `count` samples on each side of a sphere's model, whose places depend on nothing else: for
/// pictures that are compared with stored ones.
Fabricated fabricate_ball(const TriangleSoup& sphere, double delta, std::size_t count, std::size_t steps,
                          int resolution);

} // namespace isoscope::testing
