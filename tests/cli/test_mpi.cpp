// Tiles by the ranks of an MPI job: one, two and three of them, killed and gone on with, make the mesh that
// isoscope-run makes.
#include "cli/tile_line.h"
#include "input/temporary_folder.h"
#include "support/run_program.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <filesystem>
#include <string>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// mpirun with more ranks than cores, by whoever runs the tests.
std::string by_ranks(int ranks) {
  return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe -n " +
         std::to_string(ranks) + " '" ISOSCOPE_MPI_PROGRAM "' ";
}

bool has_mpirun() {
  if (run_shell("command -v mpirun").status == 0) return true;
  std::puts("SKIPPED: mpirun is not there (apt install openmpi-bin).");
  return false;
}

} // namespace

TEST_SUITE("mpirun") {
  TEST_CASE("One, two and three ranks make the same mesh, also where one of them was killed") {
    if (!has_mpirun()) return;
    const TemporaryFolder folder;
    const auto mesh_of = [&](const std::string& name, const std::string& steps) {
      const std::string tiles = quoted(folder / name), out = quoted(folder / (name + ".off"));
      const Ended ended = run_shell("T=" + tiles + "; set -e; $PROGRAM tiles cut " + model + "\"$T\"; " +
                                    steps + "; $PROGRAM tiles join \"$T\" --quiet -o " + out);
      CAPTURE(ended.error);
      CHECK(ended.status == 0);
      return bytes_of(folder / (name + ".off"));
    };
    const std::string whole = mesh_of("whole", "$PROGRAM tiles step \"$T\" --quiet");
    CHECK(!whole.empty());
    CHECK(mesh_of("one", by_ranks(1) + "\"$T\"") == whole);
    CHECK(mesh_of("two", by_ranks(2) + "\"$T\"") == whole);
    CHECK(mesh_of("three", by_ranks(3) + "\"$T\" --quiet") == whole);
    // The rank that has some tile in hand is killed, by what the tile's note says, and others with it.
    CHECK(mesh_of("killed", by_ranks(3) +
                                "\"$T\" --quiet 2>/dev/null & job=$!; "
                                "for i in $(seq 2000); do "
                                "n=$(cat \"$T\"/z/*/*.json 2>/dev/null | grep '\"in hand\"' | head -n 1 | "
                                "sed 's/.*\"process\":\\([0-9]*\\).*/\\1/') || true; "
                                "[ -n \"$n\" ] && break; sleep 0.01; done; "
                                "kill -KILL $n; ! wait $job; "
                                "$PROGRAM tiles status \"$T\" | grep -q Round; " +
                                by_ranks(2) + "\"$T\" --quiet") == whole);
  }

  TEST_CASE("A job tells its rounds, and what is wrong once") {
    if (!has_mpirun()) return;
    const TemporaryFolder folder;
    const std::string tiles = quoted(folder / "tiles");
    REQUIRE(run_shell("$PROGRAM tiles cut " + model + tiles).status == 0);
    const Ended made = run_shell(by_ranks(2) + tiles);
    CAPTURE(made.error);
    CHECK(made.status == 0);
    CHECK(made.out.find("Round        1: ") != std::string::npos);
    CHECK(made.out.find("Tiles        done, 2 ranks") != std::string::npos);
    const Ended nowhere = run_shell(by_ranks(2) + quoted(folder / "nowhere"));
    CHECK(nowhere.status == 2);
    const std::size_t once = nowhere.error.find("has no tiles");
    CHECK(once != std::string::npos);
    CHECK(nowhere.error.find("has no tiles", once + 1) == std::string::npos);
  }

  TEST_CASE("A damaged tile ends the job with its name") {
    if (!has_mpirun()) return;
    const TemporaryFolder folder;
    const std::string tiles = quoted(folder / "tiles");
    const Ended ended = run_shell("$PROGRAM tiles cut " + model + tiles + " && for f in " + tiles +
                                  "/input/*; do truncate -s 100 $f; done; " + by_ranks(2) + tiles);
    CHECK(ended.status == 3);
    CHECK(ended.says("no sound file of a tile"));
    CHECK(run_shell("cat " + tiles + "/z/1/*.json").out.find("\"failed\"") != std::string::npos);
  }
}

TEST_CASE("The program tells of itself without mpirun") {
  const Ended man = run_shell("'" ISOSCOPE_MPI_PROGRAM "' --man");
  CHECK(man.status == 0);
  CHECK(man.out.starts_with(".TH \"ISOSCOPE\\-MPI\" 1 "));
  CHECK(run_shell("'" ISOSCOPE_MPI_PROGRAM "'").status == 2);
}
