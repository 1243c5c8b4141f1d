// The files a batch run is to write: tried before the work starts.
#pragma once

#include "base/status.h"

#include <string>

namespace isoscope {

/// Where the results go; empty: nowhere, and "-" as the report is standard output.
struct Outputs {
  std::string mesh;
  std::string report;
  std::string recording;
};

/// Whether they could be written now: known extension, folders that exist and let us write, no clash with the
/// input or with each other. The recording is made, and so tried, by its writer. Fails with io or usage.
Status check_outputs(const Outputs& outputs, const std::string& input);

} // namespace isoscope
