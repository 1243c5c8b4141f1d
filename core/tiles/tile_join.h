// What is left once all tiles are made: the mesh as a file, and its certificate, summed tile by tile.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "run/pipeline.h"
#include "tiles/tile_folder.h"

#include <filesystem>
#include <memory>

namespace isoscope {

struct JoinedTiles {
  RunParameters parameters;
  std::shared_ptr<const Scene> scene; ///< without input and Ω
  RunResult result;                   ///< without the mesh
};
/// Writes the mesh of a folder whose rounds are all complete to `mesh`, where that is not empty, and proves
/// it. What is in memory is a tile's part, up to what the folder's tiles may take. Fails with usage where
/// tiles are left, with io, and with cancelled: then the mesh may be there, unproven.
Result<JoinedTiles> join_tiles(const TileFolder& folder, const std::filesystem::path& mesh,
                               RunControl& control);

/// What such a run is known to have before its first round: its input's topology, and no more.
std::shared_ptr<const Scene> scene_of(const TileFolder& folder);

} // namespace isoscope
