// A folder of tiles in the real window: while programs elsewhere make them, and a tile that is stepped
// through.
#include "input/temporary_folder.h"
#include "support/run_program.h"
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

using isoscope::TemporaryFolder;
using isoscope::test::run_shell;
using isoscope::test::run_window;

namespace {

namespace fs = std::filesystem;
const fs::path results = ISOSCOPE_RESULTS;

std::string cut(const std::string& folder) {
  return "$PROGRAM tiles cut gallery:torus '" + folder +
         "' --tolerance 2% --effort 1 --tile-memory 1.4MiB --quiet";
}

} // namespace

TEST_CASE("the window shows the states of tiles, and a click makes one once more, to be stepped through") {
  const TemporaryFolder folder;
  const std::string tiles = (folder / "torus.tiles").string();
  REQUIRE(run_shell(cut(tiles) + " && for k in 0 1 2; do $PROGRAM tiles step '" + tiles +
                    "' --tile $k --quiet; done")
              .status == 0);
  fs::create_directories(results);
  CHECK(run_window(
            "states",
            "wait settled\nexpect tiles.shown == on and tiles.round == 1 and tiles.count == 24\n"
            "expect tiles.made == 3 and tiles.waiting == 21 and tiles.in-hand == 0\n"
            "expect tiles.finished == off and tiles.left > 0 and tiles.done > 0 and tiles.done < 1\n"
            "expect tiles.facets > 3000 and tiles.facets < 4096\n"
            "expect tiles.frozen > 100 and tiles.bricks > 40 and tiles.look == opened\n"
            "screenshot " +
                (results / "states.png").string() +
                "\nset tiles.frozen-marks off\ntiles-look mesh\nwait settled\nscreenshot " +
                (results / "mesh.png").string() +
                "\ntiles-look bricks\nexpect tiles.look == bricks\nwait settled\n"
                // The rim of the ring is in the middle of the lower half.
                "move 530 560\nexpect tiles.hovered >= 0\nclick 530 560\n"
                "wait until tiles.shown == off within 120\nwait until tiles.rerun == none within 120\n"
                "wait settled\nexpect recording == opened and phase == finished and certified == on\n"
                "expect form == free and start == input and steps > 10\n"
                "first\nwait settled\nstep\nwait settled\nexpect state_step == 1 and zero_vertices > 1500\n"
                "step\nwait settled\nexpect state_step == 2\nend\nwait settled\n"
                "screenshot " +
                (results / "stepped.png").string() +
                "\ntiles\nwait settled\nexpect tiles.shown == on and tiles.made == 3\nquit\n",
            tiles) == 0);
  CHECK(run_window("unknown", "wait settled\nrerun-tile 999\nquit\n", tiles) == 1);
  CHECK(fs::exists(fs::path(tiles) / "recordings"));
  CHECK(run_shell("for f in '" + tiles + "'/recordings/*.isorun; do $PROGRAM replay --check \"$f\"; done")
            .says("the final Z is the same"));
}

TEST_CASE("the mosaic follows while another program makes the tiles, to the end") {
  const TemporaryFolder folder;
  const std::string tiles = (folder / "torus.tiles").string();
  REQUIRE(run_shell(cut(tiles)).status == 0);
  // The tiles are made once the window shows that none is.
  const std::string shown = (folder / "shown.png").string();
  REQUIRE(run_shell("(until [ -e '" + shown + "' ]; do sleep 0.1; done; $PROGRAM tiles step '" + tiles +
                    "' --quiet) >/dev/null 2>&1 &")
              .status == 0);
  CHECK(run_window(
            "follow",
            "open " + tiles +
                "\nwait until tiles.round == 1 within 120\nexpect tiles.shown == on and tiles.made == 0\n"
                "screenshot " +
                shown +
                "\nwait until tiles.made > 0 within 120\nwait until tiles.round > 2 within 120\n"
                "wait until tiles.finished == on within 300\nexpect tiles.done == 1 and tiles.left == 0\n"
                "expect tiles.waiting == 0 and tiles.in-hand == 0 and tiles.facets < 400\n"
                "open gallery:sphere paused\nexpect tiles.shown == off\nquit\n",
            "gallery:sphere --tolerance 12% --paused") == 0);
}

TEST_CASE("a picture of a folder of tiles is taken without a script, and a damaged folder is told") {
  const TemporaryFolder folder;
  const fs::path tiles = folder / "torus.tiles", picture = folder / "tiles.png";
  REQUIRE(run_shell(cut(tiles.string())).status == 0);
  CHECK(isoscope::test::exit_of(std::string(ISOSCOPE_PROGRAM) + " " + tiles.string() +
                                " --size 900x600 --screenshot " + picture.string()) == 0);
  CHECK(fs::file_size(picture) > 10000);
  CHECK(run_shell("echo '{' >'" + tiles.string() + "/tiles.json'").status == 0);
  CHECK(run_window("damaged", "open " + tiles.string() + "\nquit\n", "gallery:sphere --paused") != 0);
}
