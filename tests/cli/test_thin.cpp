// Thin parts as people meet them: statuses, what is printed, what is written.
#include "input/mesh_io.h"
#include "input/temporary_folder.h"
#include "support/run_program.h"
#include "tolerance/shapes.h"

#include <nlohmann/json.hpp>

#include <doctest/doctest.h>

#include <filesystem>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::string write(const TemporaryFolder& folder, const char* name, const TriangleSoup& soup) {
  REQUIRE(write_mesh(folder / name, {soup.points, soup.triangles}).ok());
  return (folder / name).string();
}

} // namespace

TEST_CASE("A thin part ends with 3 and a tolerance that ends with 0, or is left out with a warning") {
  const TemporaryFolder folder;
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {1, 1, 1});
  testing::add_box(soup, {2, 0, 0}, {3, 1, 0.1});
  const std::string file = write(folder, "both.off", soup), out = (folder / "out.off").string();
  const Ended refused = run_batch({file, "--tolerance", "0.07", "-o", out});
  CHECK(refused.status == 3);
  CHECK(refused.says("thinner than twice the tolerance"));
  CHECK(refused.says("--drop-thin"));
  CHECK(!std::filesystem::exists(out));
  const std::size_t at = refused.error.find("at most ", refused.error.find("Choose"));
  REQUIRE(at != std::string::npos);
  const std::string tolerance = refused.error.substr(at + 8, refused.error.find(' ', at + 8) - at - 8);
  const Ended kept = run_batch({file, "--tolerance", tolerance, "--until", "refinement"});
  CAPTURE(kept.out);
  CHECK(kept.status == 0);
  CHECK(kept.says("2 components"));
  CHECK(kept.says("the input covered within 3 δ"));
  CHECK(kept.says("topology as expected"));

  const std::string report = (folder / "report.json").string();
  const Ended dropped = run_batch(
      {file, "--tolerance", "0.07", "--until", "refinement", "--drop-thin", "-o", out, "--report", report});
  CHECK(dropped.status == 0);
  CHECK(dropped.error.find("1 part of the input, thinner than twice the tolerance everywhere, is left out") !=
        std::string::npos);
  CHECK(nlohmann::json::parse(bytes_of(report))["input"]["left_out"].size() == 1);
  const Ended quiet =
      run_batch({file, "--tolerance", "0.07", "--until", "refinement", "--drop-thin", "--quiet"});
  CHECK(quiet.status == 0);
  CHECK(quiet.out.empty());
  CHECK(quiet.error.find("left out") != std::string::npos);
}

TEST_CASE("A spike is kept; a lost one ends with 1 and its place, or with 0 where nobody asks for it") {
  const TemporaryFolder folder;
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {1, 1, 1});
  testing::add_box(soup, {0.9, 0.49, 0.49}, {2, 0.51, 0.51});
  const std::string file = write(folder, "spike.off", soup), run = (folder / "run.isorun").string();
  const std::vector<std::string> common{file, "--tolerance", "0.06", "--until", "refinement"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), common.begin(), common.end());
    return run_batch(more);
  };
  const Ended kept = with({});
  CHECK(kept.status == 0);
  CHECK(kept.says("so that the mesh stays near to what is thin"));
  CHECK(kept.says("the input covered within 3 δ"));
  // So near as this no point that is held can keep Z.
  const Ended lost = with({"--cover", "1.9", "--record", run});
  CAPTURE(lost.out);
  CHECK(lost.status == 1);
  CHECK(lost.says("The input is farther than 1.9 δ from the mesh in one place"));
  CHECK(lost.says(" δ at ("));
  CHECK(run_batch({"replay", run, "--check"}).status == 0);
  const Ended off = with({"--cover", "off"});
  CHECK(off.status == 0);
  CHECK(!off.says("covered within"));
  const Ended separate = with({"--topology", "separate"});
  CHECK(separate.status == 0);
  CHECK(separate.says("Only the sides had to be separated"));
  CHECK(separate.says("Asked for was the separation of the sides only"));
  CHECK(!separate.says("topology as expected"));
  // Who wants nothing printed but warnings is warned of both all the same.
  const Ended quiet = with({"--cover", "1.9", "--quiet"});
  CHECK(quiet.status == 1);
  CHECK(quiet.out.empty());
  CHECK(quiet.error.find("The certificate does NOT hold") != std::string::npos);
  CHECK(quiet.error.find("The input is farther than 1.9 δ from the mesh in one place") != std::string::npos);
  CHECK(quiet.error.find(" δ at (") != std::string::npos);
  const Ended quietly_separate = with({"--topology", "separate", "--quiet"});
  CHECK(quietly_separate.status == 0);
  CHECK(quietly_separate.out.empty());
  CHECK(quietly_separate.error.find("Only the sides had to be separated") != std::string::npos);
  CHECK(quietly_separate.error.find("any topology will do") == std::string::npos);
  // So is who reads the report where the summary would be.
  const Ended reported = with({"--cover", "1.9", "--report", "-"});
  CHECK(reported.status == 1);
  CHECK(reported.error.find("The input is farther than 1.9 δ") != std::string::npos);
  for (const char* wrong : {"0", "-1", "three", "", "nan", "inf"}) {
    const Ended refused = with({"--cover", wrong});
    CHECK(refused.status == 2);
    CHECK(refused.says("--cover"));
  }
}

TEST_CASE("An empty mesh is never written") {
  const TemporaryFolder folder;
  const std::string out = (folder / "out.off").string(), run = (folder / "run.isorun").string(),
                    report = (folder / "report.json").string();
  const Ended stopped = run_batch(
      {"gallery:torus", "--break", "step == 0", "-o", out, "--record", run, "--report", report, "--quiet"});
  CHECK(stopped.status == 5);
  CHECK(stopped.says("is not written"));
  CHECK(!std::filesystem::exists(out));
  CHECK(nlohmann::json::parse(bytes_of(report))["output"]["empty"] == true);
  CHECK(run_batch({"replay", run}).says("stopped"));
  CHECK(run_batch({"replay", run, "-o", out}).says("is not written"));
  CHECK(!std::filesystem::exists(out));
  CHECK(write_mesh(out, TriangleMesh{}).error().code == ErrorCode::io);
}
