// The report has the keys it promises, with the run's own figures.
#include "run/recorded_run.h"
#include "run/report.h"

#include "run/complete_run.h"
#include "run/hand_made_journal.h"

#include <nlohmann/json.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace isoscope;
using namespace isoscope::test;
using Json = nlohmann::json;

namespace {

void check_keys(const Json& object, const std::vector<const char*>& keys) {
  for (const char* key : keys) {
    CAPTURE(key);
    CHECK(object.contains(key));
  }
}

} // namespace

TEST_CASE("The report of a finished run is one JSON object with the promised keys") {
  CompleteRun run(gallery_parameters("torus"));
  REQUIRE(run.run());
  const std::string text =
      report_json(run.parameters, *run.scene, *run.result, gather_statistics(*run.journal));
  CHECK(text.back() == '\n');
  const Json report = Json::parse(text);
  check_keys(report, {"version", "input", "parameters", "samples", "stages", "output", "certificate",
                      "seconds", "peak_memory_bytes"});
  check_keys(report["input"], {"path", "vertices", "faces", "longest_edge"});
  check_keys(report["parameters"], {"tolerance", "tolerance_given", "sigma", "alpha", "fill", "robust"});
  for_each_field<RunParameters>([&](const auto& f) {
    const std::string name(f.name);
    CAPTURE(name);
    const bool told = report["parameters"].contains(name) || report["input"].contains(name);
    CHECK((name == "input" || told));
  });
  check_keys(report["samples"], {"count", "components"});
  REQUIRE(report["stages"].is_array());
  REQUIRE(!report["stages"].empty());
  for (const Json& stage : report["stages"]) {
    check_keys(stage, {"name", "seconds", "operations", "seconds_per_operation", "collapses", "found",
                       "rejected", "relaxation_sweeps", "repairs", "repair_sweeps", "failed_repairs",
                       "failed_repair_sweeps", "zero_set_vertices"});
  }
  check_keys(report["output"],
             {"vertices", "faces", "components", "euler_characteristic", "genus", "embedding"});
  check_keys(report["normals"], {"oriented", "points", "bin_degrees", "histogram", "mean", "percentile_90",
                                 "percentile_99", "above_30", "above_90"});
  check_keys(report["certificate"],
             {"closed_manifold", "oriented", "intersection_free", "within_tolerance", "max_distance",
              "input_distance", "covers", "cover_limit", "max_input_distance", "uncovered", "separates",
              "topology_as_expected", "topology_note"});

  CHECK(report["version"] == version());
  CHECK(report["input"]["path"] == "gallery:torus");
  CHECK(report["input"]["vertices"] == run.scene->input->points.size());
  CHECK(report["parameters"]["alpha"] == 0.2);
  CHECK(report["parameters"]["sigma"] == run.parameters.sigma_ratio(run.scene->default_sigma));
  CHECK(report["parameters"]["until"] == name(run.parameters.last_stage()));
  CHECK(report["parameters"]["robust"] == "auto");
  CHECK(report["samples"]["count"] == run.scene->samples->size());
  CHECK(report["stages"][0]["name"] == "refinement");
  CHECK(report["output"]["vertices"] == run.result->mesh.points.size());
  CHECK(report["output"]["genus"] == 1);
  CHECK(report["output"]["euler_characteristic"] == 0);
  CHECK(report["certificate"]["max_distance"].get<double>() <= run.scene->delta);
  CHECK(report["certificate"]["within_tolerance"] == true);
  const Json& back = report["certificate"]["input_distance"];
  CHECK(back["lower"].get<double>() <= back["upper"].get<double>());
  CHECK(back["upper"].get<double>() - back["lower"].get<double>() <= 0.0101 * run.scene->delta);
  CHECK(report["normals"]["oriented"] == true);
  CHECK(report["normals"]["histogram"].size() == 36);
  CHECK(report["normals"]["points"] == run.result->normals.points);
  CHECK(report["peak_memory_bytes"].get<double>() > 1e6);
}

TEST_CASE("The report tells every stage of a journal and whether Z left T") {
  CompleteRun run(gallery_parameters("sphere"));
  REQUIRE(run.run());
  run.result->form = ZeroForm::free;
  const std::vector<StageStatistics> stages = gather_statistics(*hand_made_journal());
  const Json report = Json::parse(report_json(run.parameters, *run.scene, *run.result, stages));
  REQUIRE(report["stages"].size() == 6);
  const std::vector<std::string> names{"refinement", "gamma", "tessellation", "zero-set", "all", "improve"};
  for (std::size_t i = 0; i < names.size(); ++i) CHECK(report["stages"][i]["name"] == names[i]);
  CHECK(report["stages"][0]["insertions"] == Json{{"containment", 4}});
  CHECK(report["stages"][1]["found"] == Json{{"halfedge", 1}, {"sample-candidate", 1}});
  CHECK(report["stages"][1]["rejected"] == Json{{"link-condition", 2}, {"kernel-empty", 1}});
  CHECK(report["stages"][5]["repairs"] == 2);
  CHECK(report["stages"][5]["failed_repair_sweeps"] == 17);
  CHECK(report["output"]["embedding"] == "Z alone");
  run.result->form = ZeroForm::embedded;
  const Json embedded = Json::parse(report_json(run.parameters, *run.scene, *run.result, stages));
  CHECK(embedded["output"]["embedding"] == "T");
}

TEST_CASE("Where any topology will do none is called expected, in the report and when it is read again") {
  CompleteRun run(gallery_parameters("sphere"));
  REQUIRE(run.run());
  using Topology = Certificate::Topology;
  for (const Topology topology :
       {Topology::as_expected, Topology::wrong, Topology::missed, Topology::not_asked}) {
    run.result->certificate.topology = topology;
    const RecordingEnd end = recording_end(run.parameters, *run.scene, *run.result, *run.journal);
    const Json told = Json::parse(end.report)["certificate"]["topology_as_expected"];
    CHECK(told.is_null() == (topology == Topology::not_asked));
    if (!told.is_null()) CHECK(told.get<bool>() == (topology == Topology::as_expected));
    const auto read = recorded_result(end, *run.journal);
    REQUIRE(read.ok());
    CHECK(read->certificate.topology == topology);
  }
}

TEST_CASE("Text files are written whole or not at all") {
  const auto folder = std::filesystem::temp_directory_path() / "isoscope test report";
  std::filesystem::create_directories(folder);
  const auto file = folder / "a report.json";
  CHECK(write_text_file(file, "one\n").ok());
  CHECK(write_text_file(file, "two\n").ok());
  std::ifstream in(file);
  CHECK(std::string(std::istreambuf_iterator<char>(in), {}) == "two\n");
  CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 1);
  const Status missing = write_text_file(folder / "nowhere" / "x.json", "x");
  REQUIRE(!missing.ok());
  CHECK(missing.error().code == ErrorCode::io);
  CHECK(missing.error().line().find("nowhere") != std::string::npos);
  CHECK(!write_text_file(folder, "x").ok());
  std::filesystem::remove_all(folder);
}
