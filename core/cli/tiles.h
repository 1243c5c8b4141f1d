// A run in tiles from the batch program.
#pragma once

#include "base/status.h"
#include "cli/outputs.h"
#include "run/parameters.h"

#include <string>

namespace isoscope {

inline const std::string usual_tile_memory = "2GiB";
inline const std::string tile_memory_help = "memory that cutting, improving one tile, and joining may take, "
                                            "as 2GiB or 512MiB: it decides how large tiles "
                                            "are; default " +
                                            usual_tile_memory;

/// "2GiB" in bytes. Fails with usage.
Result<double> read_bytes(const std::string& text);
/// Cuts, improves, joins and proves; goes on where the folder is. The exit status of the run.
int run_in_tiles(const RunParameters& parameters, const std::string& folder, const std::string& memory,
                 const Outputs& outputs, bool quiet);

} // namespace isoscope
