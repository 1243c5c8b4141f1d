// The same runs by other hands: GNU parallel, and a Slurm of one node that the test starts.
#include "sweep/tiny_models.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <fstream>

using namespace isoscope;
using namespace isoscope::test;

namespace {

namespace fs = std::filesystem;

constexpr const char* asked = " --tolerance 8%,5% --effort 0";

/// The table of the same sweep done by the program alone.
std::string expected_table(const TemporaryFolder& folder, const fs::path& models) {
  const fs::path out = folder / "alone";
  CHECK(shell("$SWEEP " + quoted(models) + asked + " --jobs 2 --quiet -o " + quoted(out)).status == 1);
  return steady_table(out / "runs.jsonl");
}

} // namespace

TEST_SUITE("parallel") {
  TEST_CASE("GNU parallel does what is missing of a list") {
    if (shell("parallel --version | grep -q GNU").status != 0) {
      std::printf("SKIPPED: GNU parallel is missing (apt install parallel)\n");
      return;
    }
    const TemporaryFolder folder;
    const auto models = make_models(folder), out = folder / "out";
    CHECK(shell("$SWEEP " + quoted(models) + asked + " -o " + quoted(out) + " --plan").text == "6\n");
    // One of them has been done already, and one part was cut in its middle.
    CHECK(shell("$SWEEP step " + quoted(out) + " --run 1").status == 0);
    std::ofstream(out / "parts" / "4.jsonl") << "{\"mod";
    CHECK(shell("$SWEEP missing " + quoted(out)).text == "0\n2\n3\n4\n5\n");
    CHECK(shell("$SWEEP merge " + quoted(out)).status == 4);
    const Said said = shell("$SWEEP missing " + quoted(out) + " | HOME=" + quoted(folder.path()) +
                            " parallel -j 2 $SWEEP step " + quoted(out) + " --run {}");
    CAPTURE(said.text);
    CHECK(said.status == 0);
    CHECK(shell("$SWEEP missing " + quoted(out)).text.empty());
    CHECK(shell("$SWEEP merge " + quoted(out) + " --quiet").status == 1);
    CHECK(steady_table(out / "runs.jsonl") == expected_table(folder, models));
    CHECK(fs::is_empty(out / "parts"));
    CHECK(fs::exists(out / "index.html"));
  }
}

TEST_SUITE("slurm") {
  TEST_CASE("A job array does the runs, and a job behind it writes the page") {
    const TemporaryFolder folder;
    const auto models = make_models(folder), out = folder / "out";
    const std::string wait = "for i in $(seq 600); do [ -f \"$OUT/index.html\" ] && break; sleep 0.2; done; "
                             "for i in $(seq 100); do [ -z \"$(squeue -h)\" ] && break; sleep 0.2; done; ";
    // Four runs in two tasks; then what was lost of them is submitted alone.
    folder.file(
        "session",
        "set -e; OUT=" + quoted(out) + "; MODELS=" + quoted(models) + "\n\"$SWEEP\" \"$MODELS\"" + asked +
            " --slurm --slurm-tasks 2 -o \"$OUT\"\n" + wait +
            "cat \"$OUT\"/parts/*.log >&2; test -f \"$OUT/index.html\"; wc -l <\"$OUT/runs.jsonl\"\n" +
            "sed -i 2d \"$OUT/runs.jsonl\"; rm \"$OUT/index.html\"\n"
            "\"$SWEEP\" --slurm -o \"$OUT\"; grep array= \"$OUT/sweep.sh\"\n" +
            wait + "test -f \"$OUT/index.html\"\n");
    const Said said =
        shell("export SWEEP; " + quoted(ISOSCOPE_WITH_SLURM) + " sh " + quoted(folder / "session"));
    if (said.status == 77) {
      std::printf("%s", said.text.c_str());
      return;
    }
    CAPTURE(said.text);
    CHECK(said.status == 0);
    CHECK(said.text.find("6 runs. The page will be") != std::string::npos);
    CHECK(said.text.find("1 run. The page will be") != std::string::npos);
    CHECK(said.text.find("--array=1\n") != std::string::npos);
    CHECK(steady_table(out / "runs.jsonl") == expected_table(folder, models));
  }
  TEST_CASE("Without Slurm the script is there and the program says what to do") {
    const TemporaryFolder folder;
    const Said said =
        shell("PATH=/nowhere $SWEEP gallery:sphere --tolerance 5% --slurm -o " + quoted(folder / "out"));
    CHECK(said.status == 1);
    CHECK(said.text.find("can be submitted by hand") != std::string::npos);
    CHECK(fs::exists(folder / "out" / "sweep.sh"));
  }
}
