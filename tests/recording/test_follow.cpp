// A recording that grows is read as it grows, and its end is told from a cut.
#include "input/temporary_folder.h"
#include "journal/synthetic.h"
#include "recording/recorded.h"
#include "run/recorded_run.h"
#include "run/session.h"
#include "support/eventually.h"

#include <doctest/doctest.h>

#include <thread>

using namespace isoscope;
using namespace isoscope::test;

TEST_CASE("A reader appends what a writer adds") {
  const TemporaryFolder folder;
  const auto file = folder / "growing.isorun";
  auto journal = std::make_shared<Journal>();
  auto writer = RecordingWriter::create(file, {std::chrono::milliseconds(1), 40});
  REQUIRE(writer.ok());
  (*writer)->start(recording_header(whole_run().parameters, whole_run().scene->input), journal);
  std::unique_ptr<RecordingReader> reader;
  REQUIRE(eventually([&] {
    auto opened = RecordingReader::open(file);
    if (opened) reader = std::move(*opened);
    return reader != nullptr;
  }));
  auto read = std::make_shared<Journal>();
  int commits = 0;
  record_insertions(*journal, 300, 300, 9, [&] {
    const auto more = reader->read_commit(*read);
    REQUIRE(more.ok());
    commits += *more ? 1 : 0;
    check_prefix(*read, *journal);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  CHECK(commits > 2);
  CHECK(reader->growing());
  (*writer)->end([] { return RecordingEnd{"stopped", false, "{}"}; });
  REQUIRE((*writer)->finish().ok());
  writer->reset();
  for (;;) {
    const auto more = reader->read_commit(*read);
    REQUIRE(more.ok());
    if (!*more) break;
  }
  check_same(*read, *journal);
  const auto end = reader->end();
  REQUIRE(end.ok());
  REQUIRE(end->has_value());
  CHECK((*end)->state == "stopped");
  // The last user of the file takes the log into it.
  CHECK(!reader->growing());
  reader.reset();
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("A session shows a finished recording without its input file") {
  const TemporaryFolder folder;
  const CompleteRun& run = whole_run();
  REQUIRE(write_recording(folder / "a.isorun", run.journal, true).ok());
  Session session;
  session.open_recording(folder / "a.isorun");
  REQUIRE(session.wait_until_settled(60));
  const SessionSnapshot s = session.snapshot();
  CHECK(s.phase == SessionPhase::finished);
  check_same(*s.journal, *run.journal);
  REQUIRE(s.scene != nullptr);
  CHECK(s.scene->delta == run.scene->delta);
  CHECK(s.scene->samples == s.journal->sample_sets()[0]);
  REQUIRE(s.result != nullptr);
  CHECK(s.result->certificate.holds());
  REQUIRE(s.recording.has_value());
  CHECK(s.recording->opened);
  CHECK(!s.recording->cut_short);
  CHECK(s.recording->events == run.journal->events().size());
  CHECK(s.parameters.input == run.parameters.input);
  // It is not a run: parameters do not set it going, and it is not recorded again.
  CHECK(session.apply(s.parameters).ok());
  CHECK(session.snapshot().phase == SessionPhase::finished);
  CHECK(!session.record(folder / "b.isorun").ok());
  // Its input can be run anew.
  RunParameters parameters = s.parameters;
  parameters.input = "no such file.off";
  session.start(parameters, s.scene->input);
  REQUIRE(session.wait_until_settled(60));
  CHECK(digest(*session.snapshot().journal) == digest(*run.journal));
}

TEST_CASE("A session says when a recording was cut short, is damaged or is none") {
  const TemporaryFolder folder;
  auto part = std::make_shared<Journal>();
  record_insertions(*part, 50, 200, 2);
  REQUIRE(write_recording(folder / "part.isorun", part, false).ok());
  Session session;
  session.open_recording(folder / "part.isorun");
  REQUIRE(session.wait_until_settled(60));
  SessionSnapshot s = session.snapshot();
  CHECK(s.phase == SessionPhase::finished);
  CHECK(s.recording->cut_short);
  CHECK(s.result == nullptr);
  CHECK(digest(*s.journal) == digest(*part));
  session.open_recording(folder.file("mesh.isorun", "OFF\n"));
  REQUIRE(session.wait_until_settled(60));
  s = session.snapshot();
  CHECK(s.phase == SessionPhase::failed);
  CHECK(s.error->message.find("is not a recording") != std::string::npos);
}

TEST_CASE("A session records its run from the first event, before, during and after") {
  const TemporaryFolder folder;
  const CompleteRun& run = whole_run();
  Session session;
  CHECK(!session.record(folder / "none.isorun").ok());
  session.start(run.parameters, nullptr, true);
  REQUIRE(session.record(folder / "early.isorun").ok());
  REQUIRE(session.wait_until_settled(60));
  CHECK(session.snapshot().phase == SessionPhase::paused);
  session.step(20);
  REQUIRE(session.wait_until_settled(60));
  // Another session follows it meanwhile.
  Session other;
  REQUIRE(eventually([&] { return session.snapshot().recording->events > 10; }));
  other.open_recording(folder / "early.isorun");
  REQUIRE(eventually([&] { return other.snapshot().phase == SessionPhase::following; }));
  session.resume();
  REQUIRE(session.wait_until_settled(60));
  REQUIRE(other.wait_until_settled(60));
  CHECK(digest(*other.snapshot().journal) == digest(*run.journal));
  CHECK(!other.snapshot().recording->cut_short);
  CHECK(other.snapshot().result != nullptr);
  // Recorded again after it has finished.
  REQUIRE(session.record(folder / "late.isorun").ok());
  const auto complete = [&] { return session.snapshot().recording->events == run.journal->events().size(); };
  CHECK(eventually(complete));
  session.start(run.parameters, nullptr, true);
  REQUIRE(session.wait_until_settled(60));
  for (const char* name : {"early.isorun", "late.isorun"}) {
    const ReadBack back = read_back(folder / name);
    REQUIRE(!back.error.has_value());
    CHECK(digest(*back.journal) == digest(*run.journal));
    REQUIRE(back.end.has_value());
    CHECK(back.end->certified);
  }
}
