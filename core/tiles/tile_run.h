// A tile made once more as a run of its own, with a journal: all of Z is there, and one tile of it changes.
#pragma once

#include "journal/recorder.h"
#include "run/pipeline.h"
#include "run/replay_check.h"
#include "tiles/tile_folder.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// What a tile is made from, of a folder or of the recording of such a run.
struct TileStart {
  RunParameters parameters;                  ///< with the round's effort
  std::shared_ptr<const TriangleSoup> input; ///< the whole one
  TriangleMesh z;                            ///< all of Z before the round
  ChangeBox box;                             ///< in which it changes
  std::vector<Vec3> kept;                    ///< points in the box that Z keeps on their side
  std::string words;                         ///< "tile 3 of round 2"
};

/// Of any round that was begun. Fails with usage where it has no such tile, or has left the tile as it was;
/// with io, bad_input.
Result<TileStart> tile_start(const TileFolder& folder, const TileRound& round, std::size_t tile);
/// What a recording of such a run began with; nothing of any other.
std::optional<TileStart> tile_start(const RunParameters& parameters,
                                    std::shared_ptr<const TriangleSoup> input, const Journal& recorded);

/// Makes the decisions that make_tile() made. Ω and the certificate are of the whole input, as in
/// join_tiles().
class TileRun {
 public:
  /// The journal starts empty.
  TileRun(TileStart start, std::shared_ptr<Journal> journal, Gate& gate, RunControl& control);
  /// Fails as Pipeline::prepare().
  Result<std::shared_ptr<const Scene>> prepare();
  /// Once, after prepare().
  Result<RunResult> run();
  const TileStart& start() const { return start_; }

 private:
  TileStart start_;
  std::shared_ptr<Journal> journal_;
  Gate& gate_;
  RunControl& control_;
  Preparation preparation_;
  std::shared_ptr<const Scene> scene_;
};

/// Whether a mesh has the facets that the tile's file has.
Result<bool> is_as_made(const TriangleMesh& mesh, const TileFolder& folder, const TileRound& round,
                        std::size_t tile);

/// A tile that was made once more and recorded.
struct RecordedTile {
  RunResult result;
  std::size_t operations = 0;
  std::optional<bool> as_made; ///< whether Z is what the tile's file has; nothing where that is not there
};
/// Runs it and records it from its first event on. `begun` is called once the file can be opened. Fails as
/// tile_start(), TileRun, and RecordingWriter.
Result<RecordedTile> record_tile(const TileFolder& folder, const TileRound& round, std::size_t tile,
                                 const std::filesystem::path& recording, RunControl& control,
                                 const std::function<void()>& begun = {});

/// Runs what a recording of a tile began with again and compares. Fails as TileRun, and with usage where the
/// recorded run did not come to its end.
Result<ReplayVerdict> check_tile_replay(TileStart start, const Journal& recorded, bool ended,
                                        RunControl& control);

} // namespace isoscope
