// Meshes and reports: written whole, found unwritable before the work starts, silent when told so.
#include "input/gallery.h"
#include "input/mesh_io.h"
#include "input/temporary_folder.h"
#include "run/certificate.h"
#include "support/run_program.h"

#include <nlohmann/json.hpp>

#include <doctest/doctest.h>

#include <filesystem>

using namespace isoscope;
using namespace isoscope::test;
using Json = nlohmann::json;

TEST_CASE("A certified run writes a mesh that is certified again when it is read, and its report") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "a folder with spaces");
  for (const char* extension : {".off", ".obj"}) {
    const auto mesh_file = folder / "a folder with spaces" / (std::string("the mesh") + extension);
    const auto report_file = folder / "a folder with spaces" / "the report.json";
    const Ended ended = run_batch(
        {"gallery:torus", "--effort", "0", "-o", mesh_file.string(), "--report", report_file.string()});
    CHECK(ended.status == 0);
    CHECK(ended.says("Certificate"));
    const Json report = Json::parse(bytes_of(report_file));
    CHECK(report["certificate"]["within_tolerance"] == true);

    const auto read = read_mesh(mesh_file);
    REQUIRE(read.ok());
    const auto input = std::make_shared<const ClosestPointIndex>(*make_gallery_model("torus"));
    const double delta = report["parameters"]["tolerance"];
    auto volume = ToleranceVolume::build(input, analyse_input(*make_gallery_model("torus")), {delta, 0.95},
                                         RunControl());
    REQUIRE(volume.ok());
    const Certificate c = certify({read->points, read->triangles}, *volume,
                                  expected_topology(*volume, TopologyMode::keep), RunControl());
    CHECK(c.holds());
    CHECK(report["output"]["faces"] == read->triangles.size());
    CHECK(report["output"]["euler_characteristic"] == c.euler_characteristic);
  }
  // Nothing temporary is left behind.
  for (const auto& entry : std::filesystem::directory_iterator(folder / "a folder with spaces")) {
    const std::string name = entry.path().filename().string();
    CHECK((name.starts_with("the mesh.") || name == "the report.json"));
  }
}

TEST_CASE("Options that differ only in threads give the same mesh") {
  const TemporaryFolder folder;
  for (const char* threads : {"1", "7"}) {
    const auto file = folder / (std::string(threads) + ".off");
    REQUIRE(run_batch({"gallery:sphere", "--quiet", "--threads", threads, "-o", file.string()}).status == 0);
  }
  CHECK(bytes_of(folder / "1.off") == bytes_of(folder / "7.off"));
}

TEST_CASE("Quiet runs print nothing, the report goes to standard output when asked to") {
  const Ended quiet = run_batch({"gallery:sphere", "--quiet"});
  CHECK(quiet.status == 0);
  CHECK(quiet.out.empty());
  CHECK(quiet.error.empty());
  const Ended report = run_batch({"gallery:sphere", "--report", "-", "--no-normals"});
  CHECK(report.status == 0);
  const Json parsed = Json::parse(report.out);
  CHECK(parsed["input"]["path"] == "gallery:sphere");
  CHECK(parsed["parameters"]["conditions"][2] == false);
  const Ended wrong = run_batch({"gallery:teapot", "--quiet"});
  CHECK(wrong.status == 3);
  CHECK(!wrong.error.empty());
}

TEST_CASE("Nothing is rewritten where no terminal is") {
  const Ended ended = run_batch({"gallery:sphere"});
  CHECK(ended.status == 0);
  CHECK(!ended.says("\r"));
  CHECK(!ended.says("\x1b"));
}

TEST_CASE("Outputs that cannot be written are found before the input is read") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "folder.off");
  const std::string missing_input = (folder / "missing.off").string();
  struct Case {
    std::vector<std::string> options;
    std::string named;
  };
  const std::string same = (folder / "same.off").string();
  const std::vector<Case> cases = {
      {{"-o", (folder / "no such folder" / "x.off").string()}, "no such folder"},
      {{"-o", (folder / "folder.off").string()}, "folder.off"},
      {{"-o", (folder / "mesh.docx").string()}, "docx"},
      {{"--report", (folder / "no such folder" / "x.json").string()}, "no such folder"},
      {{"--report", (folder / "folder.off").string()}, "folder.off"},
      {{"-o", missing_input}, "input"},
      {{"-o", same, "--report", same}, "same.off"},
  };
  for (const Case& c : cases) {
    std::vector<std::string> arguments{missing_input};
    arguments.insert(arguments.end(), c.options.begin(), c.options.end());
    const Ended ended = run_batch(arguments);
    CAPTURE(c.named);
    CHECK(ended.status == 2);
    CHECK(ended.error.find(c.named) != std::string::npos);
  }
}

TEST_CASE("Links stay links, and what they point to is written, also where nothing is yet") {
  const TemporaryFolder folder;
  for (const char* suffix : {".off", ".json", ".isorun"}) {
    std::filesystem::create_symlink(std::string("next") + suffix, folder / (std::string("first") + suffix));
    std::filesystem::create_symlink(std::string("real") + suffix, folder / (std::string("next") + suffix));
  }
  for (int time = 0; time < 2; ++time) { // the second time over what the first one has written
    const Ended ended = run_batch(
        {"gallery:sphere", "--tolerance", "12%", "--quiet", "-o", (folder / "first.off").string(), "--report",
         (folder / "first.json").string(), "--record", (folder / "first.isorun").string()});
    CAPTURE(ended.error);
    CHECK(ended.status == 0);
    for (const char* suffix : {".off", ".json", ".isorun"}) {
      CAPTURE(suffix);
      CHECK(std::filesystem::is_symlink(folder / (std::string("first") + suffix)));
      CHECK(std::filesystem::is_symlink(folder / (std::string("next") + suffix)));
      CHECK(std::filesystem::is_regular_file(folder / (std::string("real") + suffix)));
    }
  }
  const Ended clash = run_batch(
      {"gallery:sphere", "-o", (folder / "first.off").string(), "--report", (folder / "real.off").string()});
  CHECK(clash.status == 2);
}

TEST_CASE("A full disk is reported") {
  if (!std::filesystem::exists("/dev/full")) return;
  const Ended ended = run_batch({"gallery:sphere", "--quiet", "--report", "/dev/full"});
  CHECK(ended.status != 0);
  CHECK(!ended.error.empty());
}
