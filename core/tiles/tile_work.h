// Two of the three parts of a run in tiles, cut and step; for the third see tile_join.h.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "run/parameters.h"
#include "tiles/tile_folder.h"

#include <filesystem>

namespace isoscope {

/// Reads the input of a run, takes it as the first Z and cuts both into tiles of at most `memory` bytes.
/// Fails as Pipeline::prepare(), with usage where the input cannot be the first Z or the parameters ask for
/// more than the improver on Z alone does, and as TileFolder::create().
Result<TileFolder> cut_into_tiles(const RunParameters& parameters, const std::filesystem::path& folder,
                                  double memory, RunControl& control);

/// Whether a folder was cut with these parameters; threads and limits do not count.
bool is_run_of(const TileFolder& folder, const RunParameters& parameters, double memory);

/// Improves the facets of one tile of a round that lie in it with all corners, and writes what it has then.
/// A tile from which nothing could be taken the last time, nor has been since, is left as it is. The bytes
/// depend on the folder alone, not on who makes them when. Fails with io, bad_input, cancelled, or internal
/// where memory is exhausted; then nothing is written but a note of it.
Status make_tile(const TileFolder& folder, const TileRound& round, std::size_t tile,
                 const RunControl& control);

/// The same, unless the tile is there.
Status make_tile_if_missing(const TileFolder& folder, const TileRound& round, std::size_t tile,
                            const RunControl& control);

/// Makes all tiles that are left, round after round. Programs that do this at once share the tiles; towards
/// the end of a round one that another machine was at last is made anew, as it may have been left.
Status make_all_tiles(const TileFolder& folder, const RunControl& control);

} // namespace isoscope
