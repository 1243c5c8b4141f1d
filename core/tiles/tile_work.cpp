// From files to a mesh, through the improver, and back to files.
#include "tiles/tile_work.h"

#include "base/numbers.h"
#include "run/preparation.h"
#include "simplify/first_surface.h"
#include "tiles/tile_notes.h"
#include "tiles/tile_piece.h"
#include "tiles/tile_stream.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <system_error>
#include <thread>

namespace isoscope {
namespace {

/// How long one waits before looking anew whether others are done with what is left of a round.
constexpr std::chrono::milliseconds while_others_work{20};

Error cancelled_error() {
  return {ErrorCode::cancelled, "The run was stopped.", "What is done is kept: go on with the same folder."};
}

/// Nobody watches a tile.
class Unwatched : public ImproverObserver {
 public:
  bool accepted(const SurfaceChange&, const ImproverVerdict&) override { return true; }
  bool rejected(const ImproverVerdict&) override { return true; }
};

Result<TriangleMesh> read_z(const TileFolder& folder, const TileRound& round, const Box3& box) {
  auto z = folder.z_before(round.number, box);
  if (!z) return z.error();
  keep_meeting(*z, box);
  return mesh_of(std::move(*z));
}

Result<std::vector<Triangle3>> read_input(const TileFolder& folder, const Box3& box) {
  const Box3 around = box.grown(tile_input_reach * folder.manifest().delta);
  auto input = folder.input(around);
  if (!input) return input.error();
  keep_meeting(*input, around);
  return input;
}

Status improve_tile(const TileFolder& folder, const TileRound& round, const ChangeBox& bounds,
                    TriangleMesh& z, const RunControl& control) {
  const TileManifest& m = folder.manifest();
  auto input = read_input(folder, {bounds.lo, bounds.hi});
  if (!input) return input.error();
  const TileGround omega(std::move(*input), m.delta, kept_points(m, bounds), bounds, m.memory, control);
  if (control.cancelled()) return cancelled_error();
  const ImproverOptions options = tile_options(m.parameters.criteria(m.delta), round.effort);
  Unwatched nobody;
  improve(z, omega.ground(), nullptr, options, control, nobody);
  return control.cancelled() ? Status(cancelled_error()) : Status();
}

Status write_tile(const TileFolder& folder, const TileRound& round, const GridPlace& place,
                  const RunControl& control) {
  const TileGrid grid = folder.grid();
  const ChangeBox bounds = grid.bounds(round.tiling, place);
  auto z = read_z(folder, round, {bounds.lo, bounds.hi});
  if (!z) return z.error();
  const auto since = folder.in_vain_since(round, place);
  if (!since) return since.error();
  const bool any = std::any_of(z->triangles.begin(), z->triangles.end(), [&](const auto& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return bounds.holds(z->points[v]); });
  });
  if (any && !*since)
    if (Status improved = improve_tile(folder, round, bounds, *z, control); !improved) return improved;
  std::vector<Triangle3> own = facets_of(*z);
  keep_own(own, grid, round.tiling, place);
  return write_facets(folder.output(round.number, place), grid, std::move(own));
}

/// One of these tiles that nobody is known to be at, else one that another machine was at last, which may be
/// dead; nothing while programs of this one are at all of them.
std::optional<std::size_t> first_in_no_hand(const TileFolder& folder, const TileRound& round,
                                            const std::vector<std::size_t>& pending) {
  std::optional<std::size_t> elsewhere;
  for (const std::size_t tile : pending) {
    const TileReport report = report_of(folder, round.number, round.tiles[tile].tile);
    if (report.state == TileState::made) continue; // meanwhile
    if (report.state != TileState::in_hand) return tile;
    if (!report.here && !elsewhere) elsewhere = tile;
  }
  return elsewhere;
}

} // namespace

Result<TileFolder> cut_into_tiles(const RunParameters& parameters, const std::filesystem::path& folder,
                                  double memory, RunControl& control) {
  if (TileFolder::exists(folder))
    return Error{ErrorCode::usage, folder.string() + " has tiles already.",
                 "Go on with them, or name another folder."};
  RunParameters p = parameters;
  if (p.start == FirstZ::lattice)
    return Error{ErrorCode::usage, "Tiles begin with the input itself, not with a lattice.",
                 "Leave --start out."};
  p.start = FirstZ::input;
  p.time_limit = 0; // the control has it, for all parts together
  if (is_to_be_streamed(p, memory)) {
    if (Status valid = check(p); !valid) return valid.error();
    return stream_into_tiles(p, folder, memory, control);
  }
  RunParameters of_whole = p;
  of_whole.cover.reset(); // points that are held for it come from tiles
  Preparation preparation(of_whole, control);
  const auto scene = preparation.make(nullptr, {}, ThinParts::refuse);
  if (!scene) return scene.error();
  if (Status can = can_start_from_input(preparation.volume()); !can) return can.error();
  const FirstSurface first = first_from_input(preparation.volume());
  TileManifest manifest;
  manifest.parameters = p;
  manifest.delta = (*scene)->delta;
  manifest.memory = memory;
  manifest.vertices = first.mesh.points.size();
  manifest.euler_characteristic = *preparation.volume().input().euler_characteristic;
  manifest.components = preparation.volume().input().components;
  const std::vector<Triangle3> facets = facets_of(first.mesh);
  return TileFolder::create(folder, std::move(manifest), facets, facets, control);
}

bool is_run_of(const TileFolder& folder, const RunParameters& parameters, double memory) {
  RunParameters was = folder.manifest().parameters, is = parameters;
  is.start = was.start;
  is.threads = was.threads;
  is.time_limit = was.time_limit;
  is.memory_limit = was.memory_limit;
  return was == is && folder.manifest().memory == memory;
}

Status make_tile(const TileFolder& folder, const TileRound& round, std::size_t tile,
                 const RunControl& control) {
  TileInHand hand(folder, round.number, round.tiles[tile].tile);
  Status made;
  try {
    made = write_tile(folder, round, round.tiles[tile].tile, control);
  } catch (const std::bad_alloc&) {
    made = Error{ErrorCode::internal,
                 "Memory is exhausted by a tile of " + grouped(round.tiles[tile].facets) + " facets.",
                 "Cut the input anew with a smaller --tile-memory, or take a machine that has more."};
  }
  if (made)
    hand.made();
  else if (made.error().code != ErrorCode::cancelled)
    hand.failed(made.error());
  return made;
}

Status make_tile_if_missing(const TileFolder& folder, const TileRound& round, std::size_t tile,
                            const RunControl& control) {
  std::error_code failed;
  if (std::filesystem::exists(folder.output(round.number, round.tiles[tile].tile), failed)) return {};
  return make_tile(folder, round, tile, control);
}

Status make_all_tiles(const TileFolder& folder, const RunControl& control) {
  for (;;) {
    const auto round = folder.round();
    if (!round) return round.error();
    if (!*round) return {};
    const std::string part = "tiles, round " + std::to_string((*round)->number);
    for (;;) {
      const std::vector<std::size_t> pending = folder.pending(**round);
      if (pending.empty()) break;
      const std::size_t all = (*round)->tiles.size();
      control.report(part, static_cast<double>(all - pending.size()) / static_cast<double>(all));
      if (control.cancelled()) return cancelled_error();
      const auto tile = first_in_no_hand(folder, **round, pending);
      if (!tile) {
        std::this_thread::sleep_for(while_others_work);
        continue;
      }
      if (Status made = make_tile_if_missing(folder, **round, *tile, control); !made) return made;
    }
  }
}

} // namespace isoscope
