// A shortest loop on Z that does not cut its component in two: it goes around a handle or through it.
#pragma once

#include "base/run_control.h"
#include "mesh/zero_set.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

/// A closed walk along edges of Z; the last point is joined with the first.
struct SurfaceLoop {
  std::vector<std::uint32_t> vertices; ///< indices into ZeroSet::vertices
  double length = 0;
};

/// The shortest loop of its kind through each of at most `most_bases` vertices, taken evenly, and of these
/// the shortest: with every vertex a base, the shortest of the component's graph (Erickson and Har-Peled
/// 2004: tree of shortest paths, and the dual graph without it). Nothing on a component of genus 0, on one
/// that is no closed 2-manifold, and when cancelled.
std::optional<SurfaceLoop> shortest_handle_loop(const ZeroSet& zero_set, std::uint32_t component,
                                                std::size_t most_bases, const RunControl& control);

} // namespace isoscope
