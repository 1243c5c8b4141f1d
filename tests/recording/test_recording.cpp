// What was recorded is what is read: journals, states at random steps, endings.
#include "input/temporary_folder.h"
#include "journal/digest.h"
#include "journal/playback.h"
#include "journal/synthetic.h"
#include "recording/recorded.h"
#include "run/parameters_json.h"
#include "run/recorded_run.h"

#include <sqlite3.h>

#include <doctest/doctest.h>

#include <limits>
#include <random>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::int64_t ask(const std::filesystem::path& file, const char* question) {
  sqlite3* connection = nullptr;
  sqlite3_stmt* statement = nullptr;
  REQUIRE(sqlite3_open(file.c_str(), &connection) == SQLITE_OK);
  REQUIRE(sqlite3_prepare_v2(connection, question, -1, &statement, nullptr) == SQLITE_OK);
  REQUIRE(sqlite3_step(statement) == SQLITE_ROW);
  const std::int64_t answer = sqlite3_column_int64(statement, 0);
  sqlite3_finalize(statement);
  sqlite3_close(connection);
  return answer;
}

} // namespace

TEST_CASE("A whole run comes back, with its ending and its input") {
  const TemporaryFolder folder;
  const CompleteRun& run = whole_run();
  const auto file = folder / "whole.isorun";
  REQUIRE(write_recording(file, run.journal, true).ok());
  // One file remains, without a log beside it.
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
  const ReadBack back = read_back(file);
  REQUIRE(!back.error.has_value());
  check_same(*back.journal, *run.journal);
  REQUIRE(back.end.has_value());
  CHECK(back.end->state == "finished");
  CHECK(back.end->certified);
  CHECK(back.reader->header().input->points == run.scene->input->points);
  CHECK(back.reader->header().input->triangles == run.scene->input->triangles);
  CHECK(back.reader->input_digest() == digest(*run.scene->input));
  const auto result = recorded_result(*back.end, *back.journal);
  REQUIRE(result.ok());
  CHECK(result->mesh.points == run.result->mesh.points);
  CHECK(result->mesh.triangles == run.result->mesh.triangles);
  CHECK(result->certificate.holds());
  CHECK(result->certificate.max_distance == run.result->certificate.max_distance);
  CHECK(result->form == run.result->form);
  CHECK(result->last_stage == run.result->last_stage);
  CHECK(result->exit_status() == 0);
}

TEST_CASE("States at random steps are the same, forwards and backwards") {
  const TemporaryFolder folder;
  const auto journal = whole_run().journal;
  REQUIRE(write_recording(folder / "a.isorun", journal, true).ok());
  const ReadBack back = read_back(folder / "a.isorun");
  REQUIRE(!back.error.has_value());
  Playback original(journal), read(back.journal);
  std::mt19937_64 random(3);
  for (int i = 0; i < 60; ++i) {
    const auto step = static_cast<Step>(random() % (journal->steps() + 1));
    original.seek(step);
    read.seek(step);
    CHECK(digest(original.complex()) == digest(read.complex()));
    CHECK(original.complex() == read.complex());
    if (step == 0) continue;
    const Delta delta = back.journal->operations()[step - 1].delta();
    Complex undone = read.complex();
    undone.undo(delta);
    undone.apply(delta);
    CHECK(undone == read.complex());
  }
}

TEST_CASE("Sample sets that are replaced, parameters and sparse events come back") {
  const TemporaryFolder folder;
  auto journal = std::make_shared<Journal>();
  record_insertions(*journal, 400, 500, 11);
  Event odd;
  odd.value = -0.0;
  odd.limit = std::numeric_limits<double>::quiet_NaN();
  odd.point = {std::numeric_limits<double>::infinity(), -1e-300, -0.0};
  odd.text = journal->add_text("Ω \"quoted\" text\nof two lines");
  odd.detail =
      journal->add_repair({{1, 2, 3, 4, 5}, {-0.0, std::numeric_limits<double>::infinity(), 0, 0, 1}});
  journal->add_event(odd);
  odd.detail = journal->add_repair({});
  journal->add_event(odd);
  for (const std::size_t events_per_commit : {1, 7, 100000}) {
    const auto file = folder / (std::to_string(events_per_commit) + ".isorun");
    REQUIRE(write_recording(file, journal, false, events_per_commit).ok());
    const ReadBack back = read_back(file);
    REQUIRE(!back.error.has_value());
    check_same(*back.journal, *journal);
    CHECK(!back.end.has_value());
    CHECK(back.journal->sample_sets().size() == 2);
    CHECK(back.journal->texts()[odd.text] == journal->texts()[odd.text]);
  }
}

TEST_CASE("People can ask with SQL") {
  const TemporaryFolder folder;
  const auto file = folder / "a.isorun";
  const Journal& journal = *whole_run().journal;
  REQUIRE(write_recording(file, whole_run().journal, true).ok());
  std::int64_t rejected = 0;
  for (std::size_t i = 0; i < journal.events().size(); ++i)
    rejected += journal.events()[i].reason == Reason::kernel_empty ? 1 : 0;
  CHECK(ask(file, "SELECT count(*) FROM events WHERE reason='kernel-empty'") == rejected);
  CHECK(ask(file, "SELECT count(*) FROM events") == static_cast<std::int64_t>(journal.events().size()));
  CHECK(ask(file, "SELECT max(step)+1 FROM operations") == static_cast<std::int64_t>(journal.steps()));
  CHECK(ask(file, "SELECT json_extract(value,'$.effort') FROM run WHERE key='parameters'") == 2);
}

TEST_CASE("Parameters come back from JSON") {
  RunParameters p;
  p.input = "a \"strange\" näme.off";
  p.tolerance = {0.0123456789012345, false};
  p.sigma = 0.3;
  p.alpha = 0.15;
  p.shrink = 0.9;
  p.containment = Containment::sampled;
  p.topology = TopologyMode::separate;
  p.sides = SidesMode::winding;
  p.conditions[1] = p.conditions[3] = false;
  p.until = Stage::zero_set;
  p.skipped[static_cast<std::size_t>(Stage::gamma)] = true;
  p.target = TargetStrategy::octree;
  p.cost_ring = CostRing::two;
  p.effort = 3;
  p.improver = ImproverPlace::embedded;
  p.levels = {-0.5, 1.25};
  p.label = 3;
  p.drop_small = 3.5;
  p.threads = 2;
  p.drop_thin = true;
  p.cover = 1.5;
  p.time_limit = 12.5;
  p.memory_limit = 4096;
  const auto back = parse_parameters(parameters_json(p));
  REQUIRE(back.ok());
  CHECK(*back == p);
  CHECK(back->input == p.input);
  CHECK(back->tolerance.value == p.tolerance.value);
  CHECK(back->until == p.until);
  CHECK(back->skipped == p.skipped);
  CHECK(back->target == p.target);
  CHECK(back->improver == p.improver);
  CHECK(back->levels.text() == "-0.5 1.25");
  CHECK(back->label == 3);
  p.label.reset();
  CHECK(!parse_parameters(parameters_json(p))->label);
  CHECK(!parse_parameters(R"({"levels_low": 1, "levels_high": 0})").ok());
  CHECK(back->drop_small == p.drop_small);
  CHECK(back->drop_thin);
  CHECK(back->cover == 1.5);
  p.cover.reset();
  CHECK(!parse_parameters(parameters_json(p))->cover);
  CHECK(!parse_parameters(R"({"cover": 0})").ok());
  CHECK(back->conditions[0]);
  CHECK(!back->conditions[3]);
  CHECK(!parse_parameters("{").ok());
  CHECK(!parse_parameters(R"({"alpha": 7})").ok());
  CHECK(!parse_parameters(R"({"alpha": "x"})").ok());
  for (const char* wrong : {R"({"effort": 1e300})", R"({"drop_small": -1})", R"({"threads": 2.5})",
                            R"({"threads": -1})", "[1]", "null"})
    CHECK(!parse_parameters(wrong).ok());
}
