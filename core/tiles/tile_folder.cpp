// JSON for what people read, facet files for the rest.
#include "tiles/tile_folder.h"

#include "base/pending_file.h"
#include "run/parameters_json.h"
#include "run/report.h"
#include "tiles/tile_anchors.h"
#include "tiles/tile_schedule.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace isoscope {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string name_of(const GridPlace& p) {
  return std::to_string(p[0]) + "_" + std::to_string(p[1]) + "_" + std::to_string(p[2]);
}

fs::path manifest_file(const fs::path& folder) {
  return folder / "tiles.json";
}
fs::path round_file(const fs::path& folder, std::uint32_t round) {
  return folder / "rounds" / (std::to_string(round) + ".json");
}
fs::path z_folder(const fs::path& folder, std::uint32_t round) {
  return folder / "z" / std::to_string(round);
}

Json box_json(const Box3& b) {
  return {b.lo.x, b.lo.y, b.lo.z, b.hi.x, b.hi.y, b.hi.z};
}
Box3 box_of(const Json& json) {
  const auto b = json.get<std::array<double, 6>>();
  return {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
}

Json points_json(const std::vector<Vec3>& points) {
  Json json = Json::array();
  for (const Vec3 p : points) json.push_back({p.x, p.y, p.z});
  return json;
}
std::vector<Vec3> points_of(const Json& json) {
  std::vector<Vec3> points;
  for (const Json& p : json) points.push_back({p.at(0), p.at(1), p.at(2)});
  return points;
}

Result<Json> read_json(const fs::path& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  Json json = Json::parse(text.str(), nullptr, false);
  if (json.is_discarded())
    return Error{ErrorCode::bad_input, file.string() + " cannot be read.", "Cut the input anew."};
  return json;
}

std::string text_of(const TileRound& r) {
  Json tiles = Json::array();
  for (const TileWork& w : r.tiles) tiles.push_back({w.tile[0], w.tile[1], w.tile[2], w.facets});
  const Json json{{"level", r.tiling.level}, {"shift", r.tiling.shift}, {"whole", r.tiling.whole},
                  {"effort", r.effort},      {"facets", r.facets},      {"tiles", tiles}};
  return json.dump(1) + "\n";
}

Result<TileRound> read_round(const fs::path& file, std::uint32_t number) {
  const auto json = read_json(file);
  if (!json) return json.error();
  TileRound r;
  try {
    r.number = number;
    r.tiling = {json->at("level").get<std::int32_t>(), json->at("shift").get<std::int32_t>(),
                json->at("whole").get<bool>()};
    r.effort = json->at("effort").get<int>();
    r.facets = json->at("facets").get<std::uint64_t>();
    for (const Json& t : json->at("tiles"))
      r.tiles.push_back(
          {{t.at(0).get<std::int32_t>(), t.at(1).get<std::int32_t>(), t.at(2).get<std::int32_t>()},
           t.at(3).get<std::uint64_t>()});
  } catch (const Json::exception&) {
    return Error{ErrorCode::bad_input, file.string() + " cannot be read.",
                 "Delete it: it is then made again."};
  }
  return r;
}

/// The facet files of a folder by name.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.path().extension() == ".facets") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

Result<std::vector<Triangle3>> facets_of_files(const std::vector<fs::path>& files, const Box3& box) {
  // Counted first: a vector that grows takes up to three times as much.
  std::vector<fs::path> wanted;
  std::size_t count = 0;
  for (const fs::path& file : files) {
    const auto entries = read_bricks(file);
    if (!entries) return entries.error();
    const std::size_t before = count;
    for (const BrickEntry& e : *entries) count += e.box.meets(box) ? e.count : 0;
    if (count > before) wanted.push_back(file);
  }
  std::vector<Triangle3> facets;
  facets.reserve(count);
  for (const fs::path& file : wanted)
    if (Status read = read_facets(file, box, facets); !read) return read.error();
  return facets;
}

/// Files of about as many facets as a tile of the first round has.
Status write_by_tile(const fs::path& folder, const TileGrid& grid, const std::vector<Triangle3>& facets) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) return Error{ErrorCode::io, folder.string() + " cannot be made.", ""};
  std::map<GridPlace, std::vector<Triangle3>> tiles;
  for (const Triangle3& f : facets) tiles[grid.tile_of({}, grid.brick_of(canonical(f)[0]))].push_back(f);
  for (auto& [tile, own] : tiles)
    if (Status written = write_facets(folder / (name_of(tile) + ".facets"), grid, std::move(own)); !written)
      return written;
  return {};
}

Status each_of_files(const std::vector<fs::path>& files, const std::function<void(const Triangle3&)>& take) {
  for (const fs::path& file : files)
    if (Status read = each_facet(file, take); !read) return read;
  return {};
}

Result<std::vector<BrickLoad>> loads_of(const std::vector<fs::path>& z, const std::vector<fs::path>& input) {
  std::map<GridPlace, BrickLoad> bricks;
  for (const bool of_z : {true, false})
    for (const fs::path& file : of_z ? z : input) {
      const auto entries = read_bricks(file);
      if (!entries) return entries.error();
      for (const BrickEntry& e : *entries) {
        BrickLoad& load = bricks[e.brick];
        load.brick = e.brick;
        load.box.add(e.box);
        (of_z ? load.facets : load.triangles) += e.count;
      }
    }
  std::vector<BrickLoad> loads;
  for (const auto& [place, load] : bricks) loads.push_back(load);
  return loads;
}

} // namespace

Status check_tile(const TileRound& round, std::size_t tile) {
  if (tile < round.tiles.size()) return {};
  return Error{ErrorCode::usage,
               "Round " + std::to_string(round.number) + " has no tile " + std::to_string(tile) + ".",
               "It has " + std::to_string(round.tiles.size()) + ", from 0 on."};
}

bool TileFolder::exists(const fs::path& folder) {
  std::error_code failed;
  return fs::exists(manifest_file(folder), failed);
}

Result<TileFolder> TileFolder::prepare(const fs::path& folder, TileManifest manifest) {
  if (exists(folder))
    return Error{ErrorCode::usage, folder.string() + " has tiles already.",
                 "Go on with them, or name another folder."};
  for (const char* part : {"input", "rounds", "z"}) {
    std::error_code failed; // what a cut that was killed has left
    fs::remove_all(folder / part, failed);
    fs::create_directories(folder / part, failed);
    if (failed) return Error{ErrorCode::io, (folder / part).string() + " cannot be made.", ""};
  }
  std::error_code failed;
  fs::create_directories(z_folder(folder, 0), failed);
  if (failed) return Error{ErrorCode::io, z_folder(folder, 0).string() + " cannot be made.", ""};
  return TileFolder(folder, std::move(manifest));
}

Status TileFolder::seal(TileManifest manifest, const RunControl& control) const {
  const RunParameters& p = manifest.parameters;
  std::optional<double> cover;
  if (p.cover && p.topology != TopologyMode::separate) cover = *p.cover * manifest.delta;
  auto anchors = find_anchors(*this, cover, control);
  if (!anchors) return anchors.error();
  manifest.witnesses = std::move(anchors->witnesses);
  manifest.held = std::move(anchors->held);
  const Json json{{"version", version()},
                  {"parameters", Json::parse(parameters_json(manifest.parameters))},
                  {"delta", manifest.delta},
                  {"brick", manifest.brick},
                  {"box", box_json(manifest.box)},
                  {"triangles", manifest.triangles},
                  {"vertices", manifest.vertices},
                  {"euler_characteristic", manifest.euler_characteristic},
                  {"components", manifest.components},
                  {"memory", manifest.memory},
                  {"witnesses", points_json(manifest.witnesses)},
                  {"held", points_json(manifest.held)}};
  return write_text_file(manifest_file(folder_), json.dump(1) + "\n");
}

Result<TileFolder> TileFolder::create(const fs::path& folder, TileManifest manifest,
                                      const std::vector<Triangle3>& z, const std::vector<Triangle3>& input,
                                      const RunControl& control) {
  manifest.triangles = input.size();
  Box3 box;
  for (const Triangle3& t : input) box.add(isoscope::box_of(t));
  manifest.box = box.grown(manifest.delta);
  BrickCounts counts(manifest.box, 4 * manifest.delta);
  for (const Triangle3& f : z) ++counts.at(canonical(f)[0]).facets;
  for (const Triangle3& t : input) ++counts.at(canonical(t)[0]).triangles;
  manifest.brick = counts.fitting_brick(manifest.memory);
  const auto made = prepare(folder, manifest);
  if (!made) return made.error();
  if (Status written = write_by_tile(folder / "input", made->grid(), input); !written) return written.error();
  if (&z == &input) {
    if (Status shared = made->share_input(); !shared) return shared.error();
  } else if (Status written = write_by_tile(z_folder(folder, 0), made->grid(), z); !written) {
    return written.error();
  }
  if (Status sealed = made->seal(manifest, control); !sealed) return sealed.error();
  return open(folder);
}

Result<TileFolder> TileFolder::open(const fs::path& folder) {
  if (!exists(folder))
    return Error{ErrorCode::usage, folder.string() + " has no tiles.",
                 "Cut an input first: isoscope-run tiles cut."};
  const auto json = read_json(manifest_file(folder));
  if (!json) return json.error();
  TileManifest m;
  try {
    auto parameters = parse_parameters(json->at("parameters").dump());
    if (!parameters) return parameters.error();
    m.parameters = std::move(*parameters);
    m.delta = json->at("delta").get<double>();
    m.brick = json->at("brick").get<double>();
    m.box = box_of(json->at("box"));
    m.triangles = json->at("triangles").get<std::uint64_t>();
    m.vertices = json->at("vertices").get<std::uint64_t>();
    m.euler_characteristic = json->at("euler_characteristic").get<long>();
    m.components = json->at("components").get<std::size_t>();
    m.memory = json->at("memory").get<double>();
    m.witnesses = points_of(json->at("witnesses"));
    m.held = points_of(json->at("held"));
  } catch (const Json::exception&) {
    return Error{ErrorCode::bad_input, manifest_file(folder).string() + " cannot be read.",
                 "Cut the input anew."};
  }
  return TileFolder(folder, std::move(m));
}

fs::path TileFolder::input_file(const GridPlace& tile) const {
  return folder_ / "input" / (name_of(tile) + ".facets");
}

fs::path TileFolder::first_z_file(const GridPlace& tile) const {
  return output(0, tile);
}

Status TileFolder::share_input() const {
  for (const fs::path& file : files_in(folder_ / "input")) {
    const fs::path same = z_folder(folder_, 0) / file.filename();
    std::error_code failed;
    fs::remove(same, failed);
    fs::create_hard_link(file, same, failed);
    if (failed) fs::copy_file(file, same, failed); // where the disk knows no links
    if (failed) return Error{ErrorCode::io, same.string() + " cannot be made.", ""};
  }
  return {};
}

fs::path TileFolder::output(std::uint32_t round, const GridPlace& tile) const {
  return z_folder(folder_, round) / (name_of(tile) + ".facets");
}

fs::path TileFolder::note(std::uint32_t round, const GridPlace& tile) const {
  return z_folder(folder_, round) / (name_of(tile) + ".json");
}

Result<std::vector<fs::path>> TileFolder::files_before(std::uint32_t round) const {
  if (round < 2) return files_in(z_folder(folder_, 0));
  // By their names: what another machine has just written may be missing in a list that is some seconds old.
  const auto before = read_round(round_file(folder_, round - 1), round - 1);
  if (!before) return before.error();
  std::vector<fs::path> files;
  for (const TileWork& w : before->tiles) files.push_back(output(before->number, w.tile));
  std::sort(files.begin(), files.end());
  return files;
}

Result<std::vector<Triangle3>> TileFolder::z_before(std::uint32_t round, const Box3& box) const {
  const auto files = files_before(round);
  if (!files) return files.error();
  return facets_of_files(*files, box);
}

Status TileFolder::each_facet_before(std::uint32_t round,
                                     const std::function<void(const Triangle3&)>& take) const {
  const auto files = files_before(round);
  return files ? each_of_files(*files, take) : Status(files.error());
}

Status TileFolder::each_input_triangle(const std::function<void(const Triangle3&)>& take) const {
  return each_of_files(files_in(folder_ / "input"), take);
}

Result<std::vector<BrickLoad>> TileFolder::loads_before(std::uint32_t round) const {
  const auto files = files_before(round);
  if (!files) return files.error();
  return loads_of(*files, files_in(folder_ / "input"));
}

Result<std::vector<Triangle3>> TileFolder::input(const Box3& box) const {
  return facets_of_files(files_in(folder_ / "input"), box);
}

std::vector<std::size_t> TileFolder::pending(const TileRound& round) const {
  std::vector<std::size_t> left;
  std::error_code failed;
  for (std::size_t i = 0; i < round.tiles.size(); ++i)
    if (!fs::exists(output(round.number, round.tiles[i].tile), failed)) left.push_back(i);
  return left;
}

Result<std::vector<TileRound>> TileFolder::begun() const {
  std::vector<TileRound> rounds;
  std::error_code failed;
  for (std::uint32_t n = 1; fs::exists(round_file(folder_, n), failed); ++n) {
    auto read = read_round(round_file(folder_, n), n);
    if (!read) return read.error();
    rounds.push_back(std::move(*read));
  }
  return rounds;
}

Result<std::optional<TileRound>> TileFolder::plan(const std::vector<TileRound>& begun) const {
  const auto done = static_cast<std::uint32_t>(begun.size());
  const auto loads = loads_of(files_in(z_folder(folder_, done)), files_in(folder_ / "input"));
  if (!loads) return loads.error();
  TileRound round;
  round.number = done + 1;
  for (const BrickLoad& load : *loads) round.facets += load.facets;
  const auto follows =
      next_round(grid(), begun, round.facets, manifest_.parameters.effort, manifest_.memory, *loads);
  if (!follows) return std::optional<TileRound>();
  round.tiling = follows->tiling;
  round.effort = follows->effort;
  std::map<GridPlace, std::uint64_t> tiles;
  for (const BrickLoad& load : *loads)
    if (load.facets > 0) tiles[grid().tile_of(round.tiling, load.brick)] += load.facets;
  for (const auto& [tile, facets] : tiles) round.tiles.push_back({tile, facets});
  std::stable_sort(round.tiles.begin(), round.tiles.end(),
                   [](const TileWork& a, const TileWork& b) { return a.facets > b.facets; });
  return std::optional(round);
}

Result<std::optional<TileRound>> TileFolder::next(const std::vector<TileRound>& begun) const {
  auto planned = plan(begun);
  if (!planned || !*planned) return planned;
  const std::uint32_t number = (*planned)->number;
  std::error_code failed;
  fs::create_directories(z_folder(folder_, number), failed);
  if (Status written = write_text_file(round_file(folder_, number), text_of(**planned)); !written)
    return written.error();
  return planned;
}

Result<std::optional<TileRound>> TileFolder::round() const {
  auto rounds = begun();
  if (!rounds) return rounds.error();
  if (!rounds->empty() && !pending(rounds->back()).empty()) return std::optional(rounds->back());
  return next(*rounds);
}

Result<std::uint32_t> TileFolder::complete_rounds() const {
  const auto rounds = begun();
  if (!rounds) return rounds.error();
  const auto n = static_cast<std::uint32_t>(rounds->size());
  return n > 0 && !pending(rounds->back()).empty() ? n - 1 : n;
}

Result<std::optional<TileRound>> TileFolder::last_begun() const {
  const auto rounds = begun();
  if (!rounds) return rounds.error();
  return rounds->empty() ? std::optional<TileRound>() : std::optional(rounds->back());
}

Result<bool> TileFolder::is_last(const TileRound& round) const {
  auto rounds = begun();
  if (!rounds) return rounds.error();
  if (rounds->size() > round.number) return false;
  const auto follows = plan(*rounds);
  if (!follows) return follows.error();
  return !*follows;
}

Result<TileRound> TileFolder::begun(std::uint32_t number) const {
  const auto rounds = begun();
  if (!rounds) return rounds.error();
  if (number > 0 && number <= rounds->size()) return (*rounds)[number - 1];
  return Error{ErrorCode::usage, "Round " + std::to_string(number) + " was not begun.",
               rounds->empty() ? "None was." : "The last one is " + std::to_string(rounds->size()) + "."};
}

Result<std::optional<std::uint32_t>> TileFolder::in_vain_since(const TileRound& round,
                                                               const GridPlace& tile) const {
  using Since = std::optional<std::uint32_t>;
  if (round.number <= shifts) return Since();
  const std::uint32_t number = round.number - shifts;
  const auto before = begun(number);
  if (!before) return before.error();
  const bool made_then = std::any_of(before->tiles.begin(), before->tiles.end(),
                                     [&](const TileWork& w) { return w.tile == tile; });
  if (!(before->tiling == round.tiling) || before->effort != round.effort || !made_then) return Since();
  const ChangeBox bounds = grid().bounds(round.tiling, tile);
  const Box3 box{bounds.lo, bounds.hi};
  std::set<std::ptrdiff_t> counts;
  for (const std::uint32_t at : {number, number + 1, round.number}) {
    const auto facets = z_before(at, box);
    if (!facets) return facets.error();
    counts.insert(std::count_if(facets->begin(), facets->end(),
                                [&](const Triangle3& f) { return box.meets(isoscope::box_of(f)); }));
    if (counts.size() > 1) return Since();
  }
  return Since(number);
}

bool TileFolder::is_over(std::uint32_t round) const {
  std::error_code failed;
  return fs::exists(round_file(folder_, round + 1), failed);
}

} // namespace isoscope
