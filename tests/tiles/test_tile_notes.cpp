// Tiles in many hands: what is said of each, how far all are, and how they are dealt out.
#include "input/temporary_folder.h"
#include "tiles/cut_model.h"
#include "tiles/tile_dealer.h"
#include "tiles/tile_mosaic.h"
#include "tiles/tile_progress.h"

#include <doctest/doctest.h>

#include <fstream>
#include <optional>
#include <set>
#include <thread>

#include <unistd.h>

using namespace isoscope;

namespace {

TileFolder cut_sphere(const std::filesystem::path& folder) {
  return test::cut(folder, test::parameters_of("gallery:sphere", 4, 0));
}

TileRound round_of(const TileFolder& folder) {
  const auto round = folder.round();
  REQUIRE(round.ok());
  REQUIRE(round->has_value());
  return **round;
}

} // namespace

TEST_CASE("A tile waits, is in hand, and is made, or says why it is not") {
  const TemporaryFolder folder;
  const TileFolder tiles = cut_sphere(folder / "tiles");
  CHECK(progress_of(tiles)->round.number == 0);
  CHECK(!tiles.last_begun()->has_value());
  const TileRound round = round_of(tiles);
  REQUIRE(round.tiles.size() > 4);
  const auto state = [&](std::size_t i) { return report_of(tiles, 1, round.tiles[i].tile).state; };
  CHECK(state(0) == TileState::waiting);
  {
    const TileInHand hand(tiles, 1, round.tiles[0].tile);
    CHECK(state(0) == TileState::in_hand);
    const TileReport report = report_of(tiles, 1, round.tiles[0].tile);
    CHECK(report.here);
    CHECK(report.who.find(std::to_string(getpid())) != std::string::npos);
    CHECK(progress_of(tiles)->count(TileState::in_hand) == 1);
    CHECK(!progress_of(tiles)->seconds_left);
  }
  CHECK(state(0) == TileState::waiting);
  TileInHand(tiles, 1, round.tiles[1].tile).failed({ErrorCode::io, "The disk is full.", "Free some space."});
  CHECK(state(1) == TileState::failed);
  CHECK(report_of(tiles, 1, round.tiles[1].tile).words == "The disk is full. Free some space.");
  std::ofstream(tiles.note(1, round.tiles[2].tile))
      << R"({"state":"in hand","host":"elsewhere","process":1,"boot":"x","began":"1","since":0})";
  CHECK(state(2) == TileState::in_hand); // on another machine: nobody can tell
  std::ofstream(tiles.note(1, round.tiles[3].tile)) << "{\"state\":";
  CHECK(state(3) == TileState::waiting);
  REQUIRE(make_tile(tiles, round, 1, RunControl()).ok());
  CHECK(state(1) == TileState::made);
  CHECK(report_of(tiles, 1, round.tiles[1].tile).seconds > 0);
  const auto progress = progress_of(tiles);
  REQUIRE(progress.ok());
  CHECK(progress->count(TileState::made) == 1);
  CHECK(progress->rounds_to_come == 3);
  CHECK(progress->seconds_left.value_or(0) > 0);
  CHECK(progress->fraction() > 0);
  CHECK(progress->fraction() < 1);
}

TEST_CASE("A tile whose maker has ended is lost, and made by the next one") {
  const TemporaryFolder folder;
  const TileFolder tiles = cut_sphere(folder / "tiles");
  const TileRound round = round_of(tiles);
  std::string note;
  {
    const TileInHand hand(tiles, 1, round.tiles[0].tile);
    std::getline(std::ifstream(tiles.note(1, round.tiles[0].tile)), note);
  }
  const std::string began = "\"began\":\"";
  note.insert(note.find(began) + began.size(), "9"); // by another process, then
  std::ofstream(tiles.note(1, round.tiles[0].tile)) << note;
  CHECK(report_of(tiles, 1, round.tiles[0].tile).state == TileState::lost);
  REQUIRE(make_all_tiles(tiles, RunControl()).ok());
  const auto progress = progress_of(tiles);
  REQUIRE(progress.ok());
  CHECK(progress->finished);
  CHECK(progress->fraction() == 1);
  CHECK(progress->seconds_left == 0);
  CHECK(progress->count(TileState::made) == progress->tiles.size());
}

TEST_CASE("Looking begins no round, and who comes late to one makes the same") {
  const TemporaryFolder folder;
  const TileFolder tiles = cut_sphere(folder / "tiles");
  const TileRound first = round_of(tiles);
  for (std::size_t i = 0; i < first.tiles.size(); ++i)
    REQUIRE(make_tile_if_missing(tiles, first, i, RunControl()).ok());
  CHECK(progress_of(tiles)->round.number == 1);
  CHECK(!progress_of(tiles)->finished);
  CHECK(!tiles.is_over(1));
  CHECK(!*tiles.is_last(first));
  const TileRound second = round_of(tiles);
  CHECK(second.number == 2);
  CHECK(tiles.is_over(1));
  // What it was made from is there still: it comes out the same.
  const std::string bytes = bytes_of(tiles.output(1, first.tiles[0].tile));
  CHECK(make_tile(tiles, first, 0, RunControl()).ok());
  CHECK(bytes_of(tiles.output(1, first.tiles[0].tile)) == bytes);
}

TEST_CASE("Two that make all tiles at once share them") {
  const TemporaryFolder folder;
  const TileFolder tiles = cut_sphere(folder / "tiles");
  Status one, other;
  std::thread thread([&] { other = make_all_tiles(tiles, RunControl()); });
  one = make_all_tiles(tiles, RunControl());
  thread.join();
  CHECK(one.ok());
  CHECK(other.ok());
  CHECK(progress_of(tiles)->finished);
}

TEST_CASE("No tile is dealt twice, and none of a round before the one before is complete") {
  const TemporaryFolder folder;
  const TileFolder tiles = cut_sphere(folder / "tiles");
  TileDealer dealer(tiles);
  std::vector<TileRound> hands;
  std::set<std::pair<std::uint32_t, GridPlace>> seen;
  while (!dealer.finished()) {
    const auto dealt = dealer.deal();
    REQUIRE(dealt.ok());
    if (*dealt) {
      REQUIRE((*dealt)->tiles.size() == 1);
      CHECK(seen.insert({(*dealt)->number, (*dealt)->tiles[0].tile}).second);
      if (!hands.empty()) CHECK(hands.back().number == (*dealt)->number);
      hands.push_back(**dealt);
    }
    if (hands.empty() || (*dealt && hands.size() < 3)) continue;
    REQUIRE(make_tile_if_missing(tiles, hands.front(), 0, RunControl()).ok());
    hands.erase(hands.begin());
    dealer.done();
  }
  CHECK(dealer.in_hand() == 0);
  CHECK(seen.size() > dealer.round().number);
  CHECK(progress_of(tiles)->finished);
}

TEST_CASE("The mosaic has all of Z once, in bricks of its tiles, and what crosses walls is frozen") {
  const TemporaryFolder folder;
  const TileFolder tiles = cut_sphere(folder / "tiles");
  const TileRound round = round_of(tiles);
  const TileGrid grid = tiles.grid();
  for (int made = 0; made < 2; ++made) {
    const auto mosaic = mosaic_of(tiles, round, 1000000, RunControl());
    REQUIRE(mosaic.ok());
    CHECK(mosaic->facets.size() == mosaic->facet_count);
    CHECK((mosaic->facet_count == round.facets) == (made == 0));
    std::uint64_t sum = 0;
    for (const MosaicBrick& b : mosaic->bricks) {
      sum += b.facets;
      CHECK(grid.tile_of(round.tiling, b.place) == round.tiles[b.tile].tile);
    }
    CHECK(sum == mosaic->facet_count);
    // A closed surface: V − E + F is 2 with 3 F = 2 E.
    std::set<std::array<double, 3>> vertices;
    for (const Triangle3& f : mosaic->facets)
      for (const Vec3 p : f) vertices.insert({p.x, p.y, p.z});
    CHECK(2 * vertices.size() - mosaic->facet_count == 4);
    CHECK(mosaic->frozen.size() > 10);
    CHECK(mosaic->frozen.size() < vertices.size());
    const auto bricks = mosaic_of(tiles, round, 10, RunControl());
    REQUIRE(bricks.ok());
    CHECK(bricks->facets.empty());
    CHECK(bricks->facet_count == round.facets);
    if (made == 0) CHECK(bricks->bricks.size() == mosaic->bricks.size());
    REQUIRE(make_tile(tiles, round, 0, RunControl()).ok());
  }
  const Box3 box = bounds_of({-1, 0, 2}, 0.5);
  CHECK(box.lo == Vec3{-0.5, 0, 1});
  CHECK(box.hi == Vec3{0, 0.5, 1.5});
}
