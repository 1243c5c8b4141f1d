// The whole method as one call: a soup and a tolerance in, a mesh and its certificate out. What another
// program needs of this library.
#pragma once

#include "run/pipeline.h"

#include <cstddef>
#include <memory>

namespace isoscope {

/// Of the journal in memory; what is older goes to the disk.
constexpr std::size_t usual_history_mib = 2048;

/// What came out of a run, and how.
struct Approximation {
  RunResult result;                       ///< with mesh and certificate
  std::shared_ptr<const Scene> scene;     ///< what the mesh is of: δ, Ω, S; its warnings are for people
  std::shared_ptr<const Journal> journal; ///< every decision with its reason
};

/// Runs all stages that the parameters ask for on the calling thread and on the threads of the parameters;
/// their `input` is not read. A control that is cancelled, or their time limit, ends it with the mesh of the
/// moment. A mesh that could not be certified is no failure: Certificate::holds() tells. Fails with
/// bad_input, open_surface, joined_sheets, unsupported, usage (parameters) or cancelled (before there was a
/// mesh).
Result<Approximation> approximate(TriangleSoup soup, const RunParameters& parameters, RunControl& control);

} // namespace isoscope
