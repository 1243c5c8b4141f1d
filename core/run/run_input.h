// What the parameters of a run name as its input.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "input/input_mesh.h"
#include "run/parameters.h"

namespace isoscope {

/// Reads it: a file, a bundled model, the two walls of a volume, or a grid. Fails with bad_input, unsupported
/// or cancelled.
Result<InputMesh> read_run_input(const RunParameters& parameters, const RunControl& control);
/// The same without notes and without an end that somebody asks for.
Result<TriangleSoup> load_input(const RunParameters& parameters);
/// Whether what is asked of a volume that the input gives fits the input. Fails with usage.
Status check_volume(const TriangleSoup& soup, const RunParameters& parameters);

} // namespace isoscope
