// The proof of a finished mesh (architecture D7): each figure is proven, not sampled.
#pragma once

#include "base/run_control.h"
#include "criteria/topology.h"
#include "input/triangle_soup.h"
#include "run/reverse_distance.h"
#include "tolerance/tolerance_volume.h"

#include <cstdint>
#include <string>
#include <vector>

namespace isoscope {

struct Certificate {
  bool closed_manifold = false;
  bool oriented = false;
  bool intersection_free = false; ///< exact predicates
  bool within_tolerance = false;  ///< every facet proven inside Ω, rounded outward
  double max_distance =
      0; ///< proven upper bound of d over the mesh, absolute; of the failing facet when it fails
  DistanceBounds input_distance; ///< of the input to the mesh, to 1 % of δ; told, not judged
  bool separates = false;        ///< winding number at the witness of every region is that of its side
  bool topology_as_expected = false;
  /// Where nothing binds the topology and it differs from the one aimed at: both, in words; else empty.
  std::string topology_note;
  std::size_t components = 0;
  long euler_characteristic = 0;
  std::vector<std::string> failures; ///< one sentence each: which, where
  bool holds() const {
    return closed_manifold && oriented && intersection_free && within_tolerance && separates &&
           topology_as_expected;
  }
};

/// The distance of the input to the mesh takes longest and judges nothing.
enum class InputDistance : std::uint8_t { measure, leave_out };

/// What is there is judged in full even when the control is cancelled, but not when it is abandoned.
Certificate certify(const TriangleMesh& mesh, const ToleranceVolume& volume, const ExpectedTopology& expected,
                    const RunControl& control, InputDistance input_distance = InputDistance::measure);

} // namespace isoscope
