// The first Z where none has to be refined: a surface inside Ω that is known already.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "criteria/topology.h"
#include "input/triangle_soup.h"
#include "tolerance/tolerance_volume.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// Where the first Z comes from.
enum class FirstZ : std::uint8_t {
  delaunay, ///< refinement of T (§2.3)
  input,    ///< a closed input that is free of intersections: d = 0, and the topology is the input's
  lattice   ///< signs on a body-centred cubic lattice
};

struct FirstSurface {
  TriangleMesh mesh; ///< closed, oriented, free of intersections, inside Ω
  std::string words; ///< what it is, "the input itself"
  /// The surfaces that were looked at, the mesh last, where the first may have another topology than asked
  /// for.
  struct Look {
    long euler_characteristic = 0;
    std::size_t components = 0;
  };
  std::vector<Look> looks;
  std::string warning; ///< what is wrong with the last one; empty: nothing
};
/// Makes it when the run comes to it.
using FirstSurfaceMaker = std::function<Result<FirstSurface>(const RunControl&)>;

/// Whether the input itself can be the first Z: a closed manifold that is free of intersections by exact
/// predicates, and whose every wall lies between inside and outside. Fails with usage, naming the place.
Status can_start_from_input(const ToleranceVolume& volume);
/// What of it can be told before there is Ω.
Status can_start_from_input(const ToleranceField& field, const InputTopology& topology);
/// The input as Z: points of equal coordinates merged, in ascending order, turned to the outside. For a
/// volume that passed can_start_from_input().
FirstSurface first_from_input(const ToleranceVolume& volume);

/// Whether a lattice can give the first Z: the side of every point is told. Fails with usage.
Status can_start_from_lattice(const ToleranceVolume& volume);
/// Z from lattices of h = 0.95 δ, 0.95 δ/2, … 0.95 δ/4, until it has the expected topology; the last one that
/// fits the memory where none has. Fails as lattice_surface().
Result<FirstSurface> first_from_lattice(const ToleranceVolume& volume, const ExpectedTopology& expected,
                                        double most_bytes, const RunControl& control);

} // namespace isoscope
