// What the parameters of one input become for another one.
#pragma once

#include "run/parameters.h"

#include <string>

namespace isoscope {

/// The same parameters for a file or gallery:NAME: a bundled model brings its own δ or levels, lists of
/// points ask for δ to be found, and what belongs to the walls, levels or labels of another volume is gone.
RunParameters for_input(RunParameters parameters, const std::string& input);

} // namespace isoscope
