// Parameters of a run as JSON and back: what a recording keeps of them.
#pragma once

#include "run/parameters.h"

#include <string>
#include <string_view>

namespace isoscope {

/// All parameters, by the names of the options.
std::string parameters_json(const RunParameters& parameters);
/// Reads what parameters_json() wrote; a parameter that is missing keeps its default. Fails with bad_input.
Result<RunParameters> parse_parameters(std::string_view text);

} // namespace isoscope
