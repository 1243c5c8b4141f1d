// Runs in tiles as people type them: at once, in parts, killed, by GNU parallel; one mesh.
#include "cli/tile_line.h"
#include "input/temporary_folder.h"
#include "support/run_program.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <filesystem>
#include <string>

using namespace isoscope;
using namespace isoscope::test;

namespace {} // namespace

TEST_CASE("A run in tiles is certified, tells how far it is, and goes on where a kill left it") {
  const TemporaryFolder folder;
  const std::string tiles = quoted(folder / "tiles"), again = quoted(folder / "again");
  const std::filesystem::path report = folder / "r.json";
  REQUIRE(run_shell("$PROGRAM " + model + "--tiles " + tiles + " -o " + quoted(folder / "a.off") +
                    " --report " + quoted(report))
              .status == 0);
  CHECK(bytes_of(report).find("\"holds\": true") != std::string::npos);
  CHECK(run_shell("$PROGRAM tiles status " + tiles).says("done"));
  CHECK(run_shell("$PROGRAM tiles status --count " + tiles).out == "0\n");
  for (int i = 0; i < 3; ++i)
    run_shell("timeout -s KILL 1 $PROGRAM " + model + "--tiles " + again + " -o " + quoted(folder / "b.off"));
  REQUIRE(run_shell("$PROGRAM " + model + "--tiles " + again + " -o " + quoted(folder / "b.off")).status ==
          0);
  CHECK(bytes_of(folder / "a.off") == bytes_of(folder / "b.off"));
}

TEST_CASE("GNU parallel makes the same mesh" * doctest::test_suite("parallel")) {
  if (run_shell("command -v parallel").status != 0) {
    std::puts("SKIPPED: GNU parallel is not there.");
    return;
  }
  const TemporaryFolder folder;
  const std::string tiles = quoted(folder / "tiles"), whole = quoted(folder / "whole");
  REQUIRE(run_shell("$PROGRAM " + model + "--tiles " + whole + " -o " + quoted(folder / "a.off")).status ==
          0);
  const Ended ended =
      run_shell("set -e; $PROGRAM tiles cut " + model + tiles + "; while n=$($PROGRAM tiles status --count " +
                tiles + ") && [ $n -gt 0 ]; do seq 0 $((n - 1)) | parallel -j 3 $PROGRAM tiles step " +
                tiles + " --tile {} --threads 1 --quiet; done; $PROGRAM tiles join " + tiles +
                " --quiet -o " + quoted(folder / "b.off"));
  CAPTURE(ended.error);
  CHECK(ended.status == 0);
  CHECK(bytes_of(folder / "a.off") == bytes_of(folder / "b.off"));
}

TEST_CASE("Wrong words about tiles are told") {
  const TemporaryFolder folder;
  const std::string tiles = (folder / "tiles").string();
  CHECK(run_batch({"tiles"}).status == 2);
  CHECK(run_batch({"tiles", "step", tiles}).status == 2);
  CHECK(run_batch({"tiles", "cut", "gallery:sphere", tiles, "--tile-memory", "2 potatoes"}).says("no size"));
  CHECK(run_batch({"gallery:sphere", "--tiles", tiles, "--compare"}).status == 2);
  const Ended open = run_batch({"tiles", "cut", "gallery:hemisphere", tiles});
  CHECK(open.status == 2);
  CHECK(open.says("it has a border at"));
  REQUIRE(run_batch({"tiles", "cut", "gallery:sphere", tiles, "--tolerance", "5%", "--quiet"}).status == 0);
  CHECK(run_batch({"tiles", "join", tiles}).status == 2);
  CHECK(run_batch({"tiles", "step", tiles, "--tile", "x"}).status == 2);
  CHECK(run_batch({"tiles", "step", tiles, "--tile", "999"}).status == 0);
  CHECK(run_batch({"gallery:sphere", "--tolerance", "6%", "--tiles", tiles}).says("another run"));
}

TEST_CASE("A tile is made once more and recorded, and its recording replays") {
  const TemporaryFolder folder;
  const std::string tiles = quoted(folder / "tiles"), run = quoted(folder / "run.isorun");
  REQUIRE(run_shell("$PROGRAM tiles cut " + model + tiles + " && $PROGRAM tiles step " + tiles + " --tile 1")
              .status == 0);
  CHECK(run_shell("$PROGRAM tiles status " + tiles).says("1 of 8 made"));
  const Ended made = run_shell("$PROGRAM tiles rerun " + tiles + " --tile 1 --record " + run);
  CHECK(made.status == 0);
  CHECK(made.says("comes out as its file has it"));
  const Ended checked = run_shell("$PROGRAM replay --check " + run);
  CHECK(checked.status == 0);
  CHECK(checked.says("the final Z is the same"));
  CHECK(run_shell("$PROGRAM tiles rerun " + tiles + " --tile 99 --record " + run).status == 2);
  CHECK(run_shell("$PROGRAM tiles rerun " + tiles + " --tile x --record " + run).says("no number"));
}

TEST_CASE("A faster first Z is told") {
  const Ended told = run_batch({"gallery:sphere", "--tolerance", "2%", "--effort", "0"});
  CHECK(told.error.find("--start input would be faster") != std::string::npos);
  CHECK(run_batch({"gallery:sphere", "--tolerance", "2%", "--effort", "0", "--start", "input"})
            .error.find("faster") == std::string::npos);
  CHECK(run_batch({"gallery:soup", "--effort", "0"}).error.find("--start") == std::string::npos);
}
