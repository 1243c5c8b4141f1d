// A tile made once more: the decisions that made its file, as a run whose recording replays.
#include "input/temporary_folder.h"
#include "recording/recording_reader.h"
#include "run/parameters_json.h"
#include "run/passing_gate.h"
#include "tiles/cut_model.h"
#include "tiles/tile_run.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

using namespace isoscope;

namespace {

TileFolder cut_torus(const std::filesystem::path& folder) {
  return test::cut(folder, test::parameters_of("gallery:torus", 2));
}

std::vector<Triangle3> facets_in(const std::filesystem::path& file) {
  std::vector<Triangle3> facets;
  REQUIRE(read_facets(file, all_of_space, facets).ok());
  return facets;
}

} // namespace

TEST_CASE("A tile made once more comes out as its file has it, in its first round and later") {
  const TemporaryFolder folder;
  const TileFolder tiles = cut_torus(folder / "tiles");
  for (int r = 1; r <= 2; ++r) {
    const auto round = tiles.round();
    REQUIRE(round.ok());
    REQUIRE(round->has_value());
    const TileRound& now = **round;
    CHECK(now.number == static_cast<std::uint32_t>(r));
    REQUIRE(make_tile(tiles, now, 1, RunControl()).ok());
    RunControl control;
    int begun = 0;
    const auto file = folder / "run.isorun";
    const auto made = record_tile(tiles, now, 1, file, control, [&] { ++begun; });
    REQUIRE(made.ok());
    CHECK(begun == 1);
    CHECK(made->as_made == true);
    CHECK(made->operations > 1);
    CHECK(made->result.certificate.failures.empty());
    CHECK(made->result.certificate.holds());
    CHECK(made->result.certificate.euler_characteristic == 0);

    const auto reader = RecordingReader::open(file);
    REQUIRE(reader.ok());
    Journal journal;
    for (auto more = (*reader)->read_commit(journal); more.ok() && *more;
         more = (*reader)->read_commit(journal)) {}
    CHECK(journal.operations().size() == made->operations);
    auto parameters = parse_parameters((*reader)->header().parameters);
    REQUIRE(parameters.ok());
    auto start = tile_start(*parameters, (*reader)->header().input, journal);
    REQUIRE(start.has_value());
    const auto verdict = check_tile_replay(std::move(*start), journal, true, control);
    REQUIRE(verdict.ok());
    CHECK(verdict->difference.empty());
    CHECK(verdict->same);
    CHECK(verdict->to_the_end);
    CHECK(verdict->operations == made->operations);
    for (std::size_t i = 0; r == 1 && i < now.tiles.size(); ++i)
      REQUIRE(make_tile_if_missing(tiles, now, i, RunControl()).ok());
  }
}

TEST_CASE("Only what lies in the tile changes, and a recording knows what it began with") {
  const TemporaryFolder folder;
  const TileFolder tiles = cut_torus(folder / "tiles");
  const auto round = tiles.round();
  REQUIRE(round.ok());
  auto start = tile_start(tiles, **round, 0);
  REQUIRE(start.ok());
  CHECK(start->words == "0 of round 1");
  for (const Vec3 p : start->kept) CHECK(start->box.holds(p));
  start->kept.push_back(0.5 * (start->box.lo + start->box.hi));
  const std::vector<Vec3> kept = start->kept;
  const ChangeBox box = start->box;
  const TriangleMesh before = start->z;
  const auto input = start->input;
  const RunParameters parameters = start->parameters;
  auto journal = std::make_shared<Journal>();
  PassingGate gate;
  RunControl control;
  TileRun run(std::move(*start), journal, gate, control);
  REQUIRE(run.prepare().ok());
  const auto result = run.run();
  REQUIRE(result.ok());
  const auto outside = [&](const TriangleMesh& mesh) {
    std::vector<Vec3> points = mesh.points;
    std::erase_if(points, [&](Vec3 p) { return box.holds(p); });
    return points;
  };
  CHECK(outside(before).size() > 1000);
  CHECK(outside(result->mesh) == outside(before));
  CHECK(result->mesh.points.size() < before.points.size());
  const auto again = tile_start(parameters, input, *journal);
  REQUIRE(again.has_value());
  CHECK(again->words == "0 of round 1");
  CHECK(again->kept == kept);
  CHECK(again->z.points == before.points);
  CHECK(again->z.triangles == before.triangles);
  CHECK(again->box.lo == box.lo);
  CHECK(again->box.hi == box.hi);
  CHECK(!tile_start(parameters, input, Journal()).has_value());
}

TEST_CASE("What cannot be made once more is said") {
  const TemporaryFolder folder;
  const TileFolder tiles = cut_torus(folder / "tiles");
  const TileRound first = **tiles.round();
  CHECK(tile_start(tiles, first, 999).error().message == "Round 1 has no tile 999.");
  for (std::size_t i = 0; i < first.tiles.size(); ++i) REQUIRE(make_tile(tiles, first, i, RunControl()).ok());
  REQUIRE(tiles.round().ok());
  CHECK(tiles.begun(3).error().message == "Round 3 was not begun.");
}

TEST_CASE("Tiles of rounds that are over can be made once more, but not what a round has left as it was") {
  const TemporaryFolder folder;
  const TileFolder tiles = test::cut(folder / "tiles", test::parameters_of("gallery:sphere", 4), 0.3);
  REQUIRE(make_all_tiles(tiles, RunControl()).ok());
  RunControl control;
  const auto second = tiles.begun(2);
  REQUIRE(second.ok());
  const auto made = record_tile(tiles, *second, 0, folder / "run.isorun", control);
  REQUIRE(made.ok());
  CHECK(made->as_made == true);
  std::size_t left = 0;
  const std::uint32_t rounds = *tiles.complete_rounds();
  for (std::uint32_t r = 1; r <= rounds; ++r) {
    const TileRound round = *tiles.begun(r);
    auto before = *tiles.z_before(r, all_of_space);
    make_canonical(before);
    for (std::size_t i = 0; i < round.tiles.size(); ++i) {
      const auto since = tiles.in_vain_since(round, round.tiles[i].tile);
      REQUIRE(since.ok());
      if (!*since) continue;
      ++left;
      CHECK(**since + 4 == r);
      for (const Triangle3& f : facets_in(tiles.output(r, round.tiles[i].tile)))
        CHECK(std::count(before.begin(), before.end(), f) == 1);
      CHECK(tile_start(tiles, round, i).error().message.find("as it was, as round") != std::string::npos);
    }
  }
  CHECK(left > 0);
}
