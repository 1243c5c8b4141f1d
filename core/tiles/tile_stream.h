// Cuts an input that is larger than memory into tiles.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "run/parameters.h"
#include "tiles/tile_folder.h"

#include <filesystem>

namespace isoscope {

/// Makes the folder that cut_into_tiles() makes of the same file, with no more than about `memory` bytes of
/// it at once: it is sorted by tiles on the disk, and judged tile by tile. The input has to be triangles
/// whose neighbours agree on their sides; nothing is left out of it. Fails as stream_triangles(), with usage
/// where the input is no closed surface free of intersections, or asks for what only the whole tells, with io
/// and cancelled.
Result<TileFolder> stream_into_tiles(const RunParameters& parameters, const std::filesystem::path& folder,
                                     double memory, const RunControl& control);

/// Whether a file is so large that it is cut that way: what is told of an input as a whole takes many times
/// its size.
bool is_to_be_streamed(const RunParameters& parameters, double memory);

} // namespace isoscope
