// Two passes over the file, one sort, and up to three passes over the tiles.
#include "tiles/tile_stream.h"

#include "base/external_sort.h"
#include "base/place.h"
#include "base/point_order.h"
#include "input/grid_readers.h"
#include "input/mesh_stream.h"
#include "run/coordinate_check.h"
#include "tiles/tile_piece.h"
#include "tiles/tile_schedule.h"
#include "tiles/tile_surface.h"
#include "tolerance/ray_winding.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <system_error>

namespace isoscope {
namespace {

namespace fs = std::filesystem;

/// The whole is looked at in memory where the file is no larger than this share of what a tile may take, or
/// of what any machine has.
constexpr double file_share = 1.0 / 40, any_memory = 256.0 * 1024 * 1024;

Error no_surface(const std::string& why) {
  return {ErrorCode::usage, "The input cannot be the first Z: " + why + ".",
          "Tiles need a closed surface that is free of intersections."};
}

Error stopped() {
  return {ErrorCode::cancelled, "The run was stopped.", "Cut the input again."};
}

/// A facet with the tile that writes it.
struct TiledFacet {
  GridPlace tile{};
  Triangle3 facet;
};
struct TileOrder {
  bool operator()(const TiledFacet& a, const TiledFacet& b) const {
    if (a.tile != b.tile) return a.tile < b.tile;
    return comes_before(a.facet, b.facet);
  }
};

/// What a tile's facets make of an edge at a vertex in it, in the words of can_start_from_input().
std::string why_not_closed(const TriangleMesh& mesh, const std::function<bool(Vec3)>& in_tile) {
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    if (!in_tile(mesh.points[uses[i].low])) continue;
    const std::string middle =
        place(0.5 * (mesh.points[uses[i].low] + mesh.points[uses[i].high]), place_digits);
    if (end - i == 1) return "it is open, it has a border at " + middle;
    if (end - i > 2) return "the edge at " + middle + " has " + std::to_string(end - i) + " triangles";
    if (uses[i].ascends == uses[i + 1].ascends)
      return "neighbours do not agree on their sides at " + middle +
             ", which is mended only where the whole input fits into memory";
  }
  return {};
}

/// The input on its way into a folder.
class StreamedCut {
 public:
  StreamedCut(const RunParameters& parameters, fs::path folder, double memory, const RunControl& control)
      : folder_(std::move(folder)), memory_(memory), control_(control) {
    manifest_.parameters = parameters;
    manifest_.memory = memory;
  }

  Result<TileFolder> make() {
    std::error_code failed;
    fs::create_directories(folder_, failed);
    if (failed) return Error{ErrorCode::io, folder_.string() + " cannot be made.", ""};
    ScratchFile all(folder_);
    if (Status read = read_all(all); !read) return read.error();
    if (Status sized = choose_grid(all); !sized) return sized.error();
    auto made = TileFolder::prepare(folder_, manifest_);
    if (!made) return made.error();
    if (Status sorted = sort_into_tiles(all, *made); !sorted) return sorted.error();
    if (Status judged = judge(*made); !judged) return judged.error();
    if (Status turned = turn_outwards(*made); !turned) return turned.error();
    if (Status sealed = made->seal(manifest_, control_); !sealed) return sealed.error();
    return TileFolder::open(folder_);
  }

 private:
  std::size_t share() const { return static_cast<std::size_t>(memory_ / 2); }

  Status read_all(ScratchFile& all) {
    control_.report("input", -1);
    const auto read = stream_triangles(
        manifest_.parameters.input, {folder_, share()},
        [&](const Triangle3& t) {
          for (const Vec3 p : t) manifest_.box.add(p);
          all.append(&t, sizeof t);
        },
        control_);
    if (!read) return read.error();
    manifest_.triangles = read->triangles;
    return all.status();
  }

  template <class Take> Status each_of(const ScratchFile& all, const Take& take) {
    BlockReader reader(all, 0);
    SparsePoll poll(control_);
    for (std::uint64_t i = 0; i < manifest_.triangles; ++i) {
      if (poll.cancelled()) return stopped();
      take(canonical(reader.record<Triangle3>(i)));
    }
    return all.status();
  }

  Status choose_grid(const ScratchFile& all) {
    const Tolerance& tolerance = manifest_.parameters.tolerance;
    if (tolerance.automatic)
      return Error{ErrorCode::usage,
                   "--tolerance auto asks for the whole input, which is too large for that.",
                   "Give a number."};
    const double size = manifest_.box.longest_edge();
    manifest_.delta = tolerance.absolute(size);
    if (!(manifest_.delta > 1e-9 * size) || !(manifest_.delta < 100 * size))
      return Error{ErrorCode::usage,
                   "--tolerance " + tolerance.text() + " does not fit the size of the input.", ""};
    const TriangleSoup extent{{manifest_.box.lo, manifest_.box.hi}, {{0, 1, 0}}, {}};
    if (Status fine = check_coordinates(extent, manifest_.delta); !fine) return fine;
    manifest_.box = manifest_.box.grown(manifest_.delta);
    BrickCounts counts(manifest_.box, 4 * manifest_.delta);
    const Status counted = each_of(all, [&](const Triangle3& t) {
      BrickLoad& load = counts.at(t[0]);
      ++load.facets;
      ++load.triangles;
    });
    manifest_.brick = counts.fitting_brick(memory_);
    return counted;
  }

  Status sort_into_tiles(const ScratchFile& all, const TileFolder& made) {
    control_.report("tiles", -1);
    const TileGrid grid = made.grid();
    ExternalSort<TiledFacet, TileOrder> sort(share(), folder_);
    const Status added = each_of(all, [&](const Triangle3& t) {
      sort.add({grid.tile_of({}, grid.brick_of(t[0])), t});
    });
    if (!added) return added;
    std::vector<Triangle3> facets;
    Status written;
    const auto write = [&] {
      if (!facets.empty() && written.ok())
        written = write_facets(made.input_file(tiles_.back()), grid, std::move(facets));
      facets.clear();
    };
    const Status sorted = sort.each([&](const TiledFacet& f) {
      if (tiles_.empty() || tiles_.back() != f.tile) {
        write();
        tiles_.push_back(f.tile);
      }
      facets.push_back(f.facet);
    });
    write();
    return sorted ? written : sorted;
  }

  /// Calls take(mesh, in_tile) with the facets that meet each tile.
  template <class Take> Status each_tile(const TileFolder& made, const char* part, const Take& take) {
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
      control_.report(part, static_cast<double>(i) / static_cast<double>(tiles_.size()));
      if (control_.cancelled()) return stopped();
      const ChangeBox bounds = made.grid().bounds({}, tiles_[i]);
      const Box3 box{bounds.lo, bounds.hi};
      auto facets = made.input(box);
      if (!facets) return facets.error();
      keep_meeting(*facets, box);
      const TriangleMesh mesh = mesh_of(std::move(*facets));
      const std::function<bool(Vec3)> in_tile = [&](Vec3 p) { return bounds.holds(p); };
      if (Status taken = take(i, mesh, in_tile); !taken) return taken;
    }
    return {};
  }

  /// Each brick with facets is in one of the tiles that have files; vertices in others, which have none, are
  /// the highest of their facets.
  Status judge(const TileFolder& made) {
    const auto loads = made.loads_before(1);
    if (!loads) return loads.error();
    tiles_ = tiles_met(made.grid(), {}, *loads);
    const Status judged =
        each_tile(made, "closed surface", [&](std::size_t, const TriangleMesh& mesh, const auto& in_tile) {
          const TileSurface surface = judge_surface(mesh, in_tile, [this] { return control_.cancelled(); });
          if (control_.cancelled()) return Status(stopped());
          if (!surface.closed_manifold || !surface.oriented) {
            const std::string why = why_not_closed(mesh, in_tile);
            return Status(no_surface(!why.empty() ? why : "it is no closed manifold"));
          }
          if (surface.intersections > 0)
            return Status(
                no_surface("it meets itself, in a triangle at " + place(surface.intersection, place_digits)));
          first_parts_.push_back(parts_.add(surface));
          manifest_.vertices += surface.vertices;
          manifest_.euler_characteristic += surface.euler_characteristic;
          return Status();
        });
    if (!judged) return judged;
    parts_.join();
    manifest_.components = parts_.components().size();
    return {};
  }

  /// Calls take(component, facet) for what counts in a tile.
  template <class Take>
  void each_facet_in(std::size_t tile, const TriangleMesh& mesh, const std::function<bool(Vec3)>& in_tile,
                     const Take& take) const {
    const std::vector<std::size_t> parts = parts_of_facets(mesh, in_tile);
    for (std::size_t f = 0; f < parts.size(); ++f) {
      if (parts[f] == no_part) continue;
      const auto& t = mesh.triangles[f];
      take(parts_.component_of(first_parts_[tile] + parts[f]),
           Triangle3{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
    }
  }

  /// A component encloses a volume, and one in an odd number of others bounds a cavity.
  Status turn_outwards(const TileFolder& made) {
    const std::vector<SurfacePart>& components = parts_.components();
    std::vector<char> turned;
    for (const SurfacePart& c : components) turned.push_back(c.volume < 0 ? 1 : 0);
    if (components.size() > 1)
      if (Status nested = find_cavities(made, turned); !nested) return nested;
    const bool any = std::find(turned.begin(), turned.end(), 1) != turned.end();
    if (any)
      if (Status written = write_turned(made, turned); !written) return written;
    return made.share_input();
  }

  /// Files are replaced once all of them have been read.
  Status write_turned(const TileFolder& made, const std::vector<char>& turned) {
    const Status written =
        each_tile(made, "orientation",
                  [&](std::size_t i, const TriangleMesh& mesh, const std::function<bool(Vec3)>& in_tile) {
                    std::vector<Triangle3> own;
                    each_facet_in(i, mesh, in_tile, [&](std::size_t component, Triangle3 f) {
                      if (turned[component] != 0) std::swap(f[1], f[2]);
                      own.push_back(f);
                    });
                    return own.empty()
                               ? Status()
                               : write_facets(made.first_z_file(tiles_[i]), made.grid(), std::move(own));
                  });
    if (!written) return written;
    for (const GridPlace& tile : tiles_) {
      std::error_code failed;
      if (!fs::exists(made.first_z_file(tile), failed)) continue;
      fs::rename(made.first_z_file(tile), made.input_file(tile), failed);
      if (failed) return Error{ErrorCode::io, made.input_file(tile).string() + " cannot be written.", ""};
    }
    return {};
  }

  Status find_cavities(const TileFolder& made, std::vector<char>& turned) {
    const std::vector<SurfacePart>& components = parts_.components();
    std::vector<Vec3> points;
    for (const SurfacePart& c : components) points.push_back(c.vertex);
    RayWinding around(std::move(points));
    const Status counted =
        each_tile(made, "cavities",
                  [&](std::size_t i, const TriangleMesh& mesh, const std::function<bool(Vec3)>& in_tile) {
                    each_facet_in(i, mesh, in_tile, [&](std::size_t component, const Triangle3& f) {
                      around.add(f, component);
                    });
                    return Status();
                  });
    if (!counted) return counted;
    const std::vector<int> windings = around.windings();
    for (std::size_t c = 0; c < components.size(); ++c)
      if (windings[c] % 2 != 0) turned[c] = turned[c] != 0 ? 0 : 1;
    return {};
  }

  fs::path folder_;
  double memory_;
  const RunControl& control_;
  TileManifest manifest_;
  std::vector<GridPlace> tiles_;
  std::vector<std::size_t> first_parts_; ///< by tile
  PartUnion parts_;
};

} // namespace

Result<TileFolder> stream_into_tiles(const RunParameters& parameters, const fs::path& folder, double memory,
                                     const RunControl& control) {
  if (parameters.drop_small > 0)
    return Error{ErrorCode::usage, "--drop-small asks for the whole input, which is too large for that.",
                 "Leave it out."};
  return StreamedCut(parameters, folder, memory, control).make();
}

bool is_to_be_streamed(const RunParameters& parameters, double memory) {
  if (!parameters.inside.empty() || is_grid_file(parameters.input)) return false;
  std::error_code failed;
  const std::uintmax_t size = fs::file_size(parameters.input, failed);
  return !failed && static_cast<double>(size) > file_share * std::max(memory, any_memory);
}

} // namespace isoscope
