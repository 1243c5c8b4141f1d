// A folder of tiles: what was cut, the rounds, and which tiles are left to do. All state is in files, each of
// which is there whole or not at all, so that any number of programs may work on it, and be killed.
//
//   tiles.json        what was cut, with the parameters
//   input/x_y_z       the input's triangles, turned outwards
//   rounds/N.json     the tiling of round N, with its tiles, heaviest first
//   z/N/x_y_z         the facets of Z that a tile of round N has left; z/0 is mostly the input's own files
//   z/N/x_y_z.json    what programs say of that tile, see tile_notes.h
//   recordings/       of tiles that the window made once more
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "run/parameters.h"
#include "tiles/facet_file.h"
#include "tiles/tile_grid.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// What tiles.json says.
struct TileManifest {
  RunParameters parameters;
  double delta = 0;                          ///< absolute
  double brick = 0;                          ///< side, a power of two
  Box3 box;                                  ///< of the input
  std::uint64_t triangles = 0, vertices = 0; ///< of the input
  long euler_characteristic = 0;
  std::size_t components = 0;
  double memory = 0;           ///< bytes that the improver may take for a tile
  std::vector<Vec3> witnesses; ///< points of regions deeper than δ, see TileAnchors
  std::vector<Vec3> held;      ///< points in thin parts that Z keeps on their side, so that it stays near
};

/// Z and the input by brick: how many facets begin there, and the box of these.
struct BrickLoad {
  GridPlace brick{};
  std::uint64_t facets = 0, triangles = 0;
  Box3 box;
};

/// One tile of a round.
struct TileWork {
  GridPlace tile{};
  std::uint64_t facets = 0; ///< of Z whose lowest vertex it holds, before the round
};
struct TileRound {
  std::uint32_t number = 0; ///< from 1
  Tiling tiling;
  int effort = 1;           ///< of the improver
  std::uint64_t facets = 0; ///< of Z before it
  std::vector<TileWork> tiles;
};

/// Fails with usage where a round has no tile of that number.
Status check_tile(const TileRound& round, std::size_t tile);

class TileFolder {
 public:
  /// Makes the folder from a first Z and the input, both oriented; the box, the bricks, the number of
  /// triangles and the points that Z keeps on their side follow from them. Fails with usage where the folder
  /// has tiles already, with io, cancelled, and as find_anchors().
  static Result<TileFolder> create(const std::filesystem::path& folder, TileManifest manifest,
                                   const std::vector<Triangle3>& z, const std::vector<Triangle3>& input,
                                   const RunControl& control = {});
  /// The same in steps, for who has not all of it in memory. First the folder, of a manifest that has all but
  /// what is found out on the way; then input_file() and first_z_file() of each tile of the first tiling are
  /// to be written, and what they hold can be read back; seal() finds the points and makes tiles of them.
  /// Both fail as create().
  static Result<TileFolder> prepare(const std::filesystem::path& folder, TileManifest manifest);
  Status seal(TileManifest manifest, const RunControl& control) const;
  std::filesystem::path input_file(const GridPlace& tile) const;
  /// Takes the input's files as those of the first Z.
  Status share_input() const;
  std::filesystem::path first_z_file(const GridPlace& tile) const;
  /// Fails with usage where there are no tiles, with bad_input where they cannot be read.
  static Result<TileFolder> open(const std::filesystem::path& folder);
  /// Whether a folder has tiles.
  static bool exists(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }
  const TileManifest& manifest() const { return manifest_; }
  TileGrid grid() const { return {manifest_.brick, manifest_.box}; }

  /// The round that is at hand: the last one that was begun, or, where all its tiles are there, the next,
  /// which is begun by that. Nothing once no round is worthwhile any more. What it gives depends on the files
  /// only.
  Result<std::optional<TileRound>> round() const;
  /// The tiles of a round that are not there yet, by their places in its list.
  std::vector<std::size_t> pending(const TileRound& round) const;
  /// Rounds that are complete.
  Result<std::uint32_t> complete_rounds() const;
  /// The round that was begun last, for who only looks: nothing is begun by that. Nothing where none was.
  Result<std::optional<TileRound>> last_begun() const;
  /// Whether no round follows one whose tiles are all there, as far as its files tell; begins none either.
  Result<bool> is_last(const TileRound& round) const;
  /// A round that was begun, by its number. Fails with usage where there is no such, with bad_input.
  Result<TileRound> begun(std::uint32_t number) const;
  /// Whether a later round was begun: then all tiles of this one are there.
  bool is_over(std::uint32_t round) const;
  /// The round of the same tiling and effort, shifts before, in which a tile lost no facet, where as many
  /// meet the tile now as then: it is left as it is this time. Nothing where there is no such round. Fails as
  /// z_before().
  Result<std::optional<std::uint32_t>> in_vain_since(const TileRound& round, const GridPlace& tile) const;

  std::filesystem::path output(std::uint32_t round, const GridPlace& tile) const;
  std::filesystem::path note(std::uint32_t round, const GridPlace& tile) const;
  /// Facets of Z before a round, and triangles of the input, whose bricks' boxes meet a box.
  Result<std::vector<Triangle3>> z_before(std::uint32_t round, const Box3& box) const;
  Result<std::vector<Triangle3>> input(const Box3& box) const;
  /// The same of all of space, one by one.
  Status each_facet_before(std::uint32_t round, const std::function<void(const Triangle3&)>& take) const;
  Status each_input_triangle(const std::function<void(const Triangle3&)>& take) const;
  /// The bricks of both, ascending.
  Result<std::vector<BrickLoad>> loads_before(std::uint32_t round) const;

 private:
  TileFolder(std::filesystem::path folder, TileManifest manifest)
      : folder_(std::move(folder)), manifest_(std::move(manifest)) {}
  Result<std::vector<TileRound>> begun() const;
  Result<std::vector<std::filesystem::path>> files_before(std::uint32_t round) const;
  Result<std::optional<TileRound>> plan(const std::vector<TileRound>& begun) const;
  Result<std::optional<TileRound>> next(const std::vector<TileRound>& begun) const;

  std::filesystem::path folder_;
  TileManifest manifest_;
};

} // namespace isoscope
