// Sessions: every command does what it says, in any order, while others watch.
#include "run/session.h"

#include "journal/playback.h"
#include "questions/snapshot.h"
#include "recording/recording_reader.h"
#include "run/complete_run.h"
#include "run/run_input.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include <unistd.h>

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr double patience = 60; // seconds; only a hang reaches it

SessionSnapshot settled(const Session& session) {
  REQUIRE(session.wait_until_settled(patience));
  return session.snapshot();
}

/// To the last stage with the least effort.
RunParameters quick(const char* model) {
  RunParameters parameters = complete_parameters(model);
  parameters.effort = 0;
  return parameters;
}

SessionSnapshot started_paused(Session& session, const char* model) {
  session.start(gallery_parameters(model), nullptr, true);
  return settled(session);
}

} // namespace

TEST_CASE("A session that was not started is idle and shrugs at commands") {
  Session session;
  CHECK(session.snapshot().phase == SessionPhase::idle);
  session.pause();
  session.resume();
  session.stop();
  session.step();
  CHECK(session.snapshot().journal == nullptr);
}

TEST_CASE("The input is there as soon as it is read, also where nothing comes of it") {
  Session session;
  RunParameters thin = gallery_parameters("sphere");
  thin.memory_limit = 1; // far too little
  session.start(thin);
  const SessionSnapshot refused = settled(session);
  CHECK(refused.phase == SessionPhase::failed);
  CHECK(refused.scene == nullptr);
  REQUIRE(refused.input != nullptr);
  CHECK(refused.input->name == "sphere");
  session.start(gallery_parameters("sphere"), nullptr, true);
  const SessionSnapshot prepared = settled(session);
  REQUIRE(prepared.scene != nullptr);
  CHECK(prepared.input == prepared.scene->input);
}

TEST_CASE("A session runs to the same journal as the pipeline alone") {
  CompleteRun alone(gallery_parameters("sphere"));
  REQUIRE(alone.run());
  Session session;
  session.start(gallery_parameters("sphere"));
  const SessionSnapshot s = settled(session);
  CHECK(s.phase == SessionPhase::finished);
  REQUIRE(s.result);
  CHECK(s.result->certificate.holds());
  CHECK(digest(*s.journal) == digest(*alone.journal));
}

TEST_CASE("Started paused, it stops before the first Steiner point; steps are exact") {
  Session session;
  SessionSnapshot s = started_paused(session, "torus");
  CHECK(s.phase == SessionPhase::paused);
  REQUIRE(s.scene);
  CHECK(s.journal->steps() == 1);
  CHECK(s.result == nullptr);
  for (const std::uint32_t n : {1u, 1u, 5u, 17u}) {
    const Step before = s.journal->steps();
    session.step(n);
    s = settled(session);
    CHECK(s.phase == SessionPhase::paused);
    CHECK(s.pause_note == "step");
    CHECK(s.journal->steps() == before + n);
  }
  session.resume();
  s = settled(session);
  CHECK(s.phase == SessionPhase::finished);
  CompleteRun alone(gallery_parameters("torus"));
  REQUIRE(alone.run());
  CHECK(digest(*s.journal) == digest(*alone.journal));
}

TEST_CASE("Pausing holds the run between two operations until it is told to go on") {
  Session session;
  session.start(gallery_parameters("torus"));
  session.pause();
  SessionSnapshot s = settled(session);
  CHECK(s.phase == SessionPhase::paused);
  const Step held = s.journal->steps();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK(s.journal->steps() == held);
  session.resume();
  CHECK(settled(session).phase == SessionPhase::finished);
}

TEST_CASE("It runs until an event that somebody waits for") {
  Session session;
  started_paused(session, "torus");
  session.run_until([](const Journal&, const Event& e) {
    return e.kind == EventKind::insertion && e.condition == Condition::classification && e.step >= 30
               ? std::string("step 30 of condition 1")
               : std::string();
  });
  SessionSnapshot s = settled(session);
  CHECK(s.phase == SessionPhase::paused);
  CHECK(s.pause_note == "step 30 of condition 1");
  CHECK(s.journal->steps() == 31);
  CHECK(s.journal->events().back().condition == Condition::classification);
  session.resume(); // it was for once
  CHECK(settled(session).phase == SessionPhase::finished);
}

TEST_CASE("A breakpoint stands until it is removed") {
  Session session;
  session.set_breakpoint([](const Journal& journal, const Event& e) {
    return e.operation && journal.steps() % 20 == 0 ? std::string("twenty more") : std::string();
  });
  session.start(gallery_parameters("sphere"));
  for (const Step expected : {20u, 40u}) {
    const SessionSnapshot s = settled(session);
    CHECK(s.phase == SessionPhase::paused);
    CHECK(s.pause_note == "twenty more");
    CHECK(s.journal->steps() == expected);
    session.resume();
  }
  settled(session);
  session.set_breakpoint({});
  session.resume();
  CHECK(settled(session).phase == SessionPhase::finished);
}

TEST_CASE("Stopping keeps what is there and judges it") {
  Session session;
  started_paused(session, "torus");
  session.step(40);
  settled(session);
  session.stop();
  const SessionSnapshot s = settled(session);
  CHECK(s.phase == SessionPhase::finished);
  REQUIRE(s.result);
  CHECK(s.result->end == RunResult::End::stopped);
  CHECK(s.journal->steps() <= 42);
}

TEST_CASE("Parameters change during a run, while paused and after its end") {
  Session session;
  started_paused(session, "sphere");
  session.step(30);
  settled(session);
  RunParameters p = gallery_parameters("sphere");
  p.alpha = 0.4;
  CHECK(session.apply(p).ok());
  session.resume();
  SessionSnapshot s = settled(session);
  CHECK(s.phase == SessionPhase::finished);
  CHECK(s.parameters.alpha == 0.4);
  CHECK(s.journal->parameters_at(s.journal->steps()).alpha == 0.4);
  CHECK(s.journal->parameters_at(1).alpha == 0.2);
  const Step before = s.journal->steps();
  const std::uint64_t generation = s.generation;

  p.alpha = 0.6;
  CHECK(session.apply(p).ok());
  s = settled(session);
  CHECK(s.phase == SessionPhase::finished);
  CHECK(s.generation == generation);
  CHECK(s.journal->steps() >= before);
  CHECK(s.journal->parameters_at(s.journal->steps()).alpha == 0.6);

  p.sigma = 0.3;
  CHECK(session.apply(p).ok());
  s = settled(session);
  REQUIRE(s.phase == SessionPhase::finished);
  CHECK(s.journal->sample_sets().size() == 2);
  CHECK(s.result->certificate.holds());
}

TEST_CASE("A density that takes more memory than it may is refused, and the run goes on as it was") {
  Session session;
  started_paused(session, "sphere");
  session.step(10);
  settled(session);
  RunParameters p = gallery_parameters("sphere");
  p.sigma = 0.001;
  p.memory_limit = 100;
  const Status refused = session.apply(p);
  REQUIRE(!refused.ok());
  CHECK(refused.error().message.find("A density of 0.001 δ takes about") == 0);
  CHECK(session.snapshot().parameters.sigma == 0);
  session.resume();
  const SessionSnapshot s = settled(session);
  REQUIRE(s.phase == SessionPhase::finished);
  CHECK(s.journal->sample_sets().size() == 1);
}

TEST_CASE("A stopped run goes on after parameters were applied") {
  Session session;
  started_paused(session, "sphere");
  session.stop();
  SessionSnapshot s = settled(session);
  CHECK(s.result->end == RunResult::End::stopped);
  CHECK(session.apply(gallery_parameters("sphere")).ok());
  s = settled(session);
  REQUIRE(s.phase == SessionPhase::finished);
  CHECK(s.result->end == RunResult::End::finished);
  CHECK(s.result->certificate.holds());
}

TEST_CASE("Parameters change while Z is simplified, and a stopped simplification goes on") {
  Session session;
  session.start(quick("torus"), nullptr, true);
  settled(session);
  session.run_until([](const Journal&, const Event& e) {
    return std::string(e.kind == EventKind::collapse && e.stage == Stage::zero_set ? "there" : "");
  });
  SessionSnapshot s = settled(session);
  REQUIRE(s.phase == SessionPhase::paused);
  RunParameters p = quick("torus");
  p.shrink = 0.5;
  CHECK(session.apply(p).ok());
  session.step(3);
  s = settled(session);
  CHECK(s.journal->parameters_at(s.journal->steps()).shrink == 0.5);
  session.stop();
  s = settled(session);
  REQUIRE(s.phase == SessionPhase::finished);
  CHECK(s.result->end == RunResult::End::stopped);
  CHECK(s.result->last_stage == Stage::zero_set);
  CHECK(s.result->certificate.holds());
  const std::size_t vertices = s.result->mesh.points.size();
  CHECK(session.apply(p).ok());
  s = settled(session);
  CHECK(s.result->end == RunResult::End::finished);
  CHECK(s.result->last_stage == Stage::improve);
  CHECK(s.result->certificate.holds());
  CHECK(s.result->mesh.points.size() < vertices);
}

TEST_CASE("Starting anew replaces the run under way with a new journal") {
  Session session;
  session.start(gallery_parameters("bracket"));
  const auto first = session.snapshot();
  session.start(gallery_parameters("sphere"));
  const auto second = settled(session);
  CHECK(second.phase == SessionPhase::finished);
  CHECK(second.generation == first.generation + 1);
  CHECK(second.journal != first.journal);
  CHECK(second.scene->input->name == "sphere");
}

TEST_CASE("A session ends at once, whatever it is doing") {
  for (const int operations : {0, 1, 100}) {
    Session session;
    RunParameters p = gallery_parameters("bracket");
    p.tolerance = {2.5, true};
    session.start(p);
    const auto journal = session.snapshot().journal;
    while (journal->steps() < static_cast<Step>(operations) &&
           session.snapshot().phase < SessionPhase::finished) {
      std::this_thread::yield();
    }
  }
}

TEST_CASE("A session whose run does not obey closes its recording before it waits") {
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                     ("isoscope_disobedient_" + std::to_string(getpid()) + ".isorun"),
                              log = file.string() + "-wal";
  std::atomic<bool> stuck{false}, released{false};
  auto session = std::make_unique<Session>();
  session->set_breakpoint([&](const Journal& journal, const Event&) -> std::string {
    if (journal.events().size() < 100 || released) return {};
    stuck = true;
    while (!released) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return {};
  });
  session->start(gallery_parameters("torus"));
  REQUIRE(session->record(file).ok());
  const auto wait_for = [](const auto& what) {
    for (int i = 0; i < 1000 * patience && !what(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return what();
  };
  REQUIRE(wait_for([&] { return stuck.load(); }));
  std::thread end([&] { session.reset(); });
  // A recording that is closed has no log beside it, and everything that there was.
  const bool closed = wait_for([&] { return !std::filesystem::exists(log); });
  std::size_t events = 0;
  if (auto opened = RecordingReader::open(file)) {
    Journal read;
    while ((*opened)->read_commit(read).ok() && read.events().size() > events) events = read.events().size();
  }
  CHECK(closed);
  CHECK(events >= 99);
  CHECK_FALSE(released);
  released = true;
  end.join();
  std::filesystem::remove(file);
}

TEST_CASE("A session that is abandoned ends") {
  Session session;
  session.start(gallery_parameters("torus"));
  session.abandon();
  CHECK(session.wait_until_settled(patience));
}

TEST_CASE("What fails says why") {
  Session session;
  RunParameters p = gallery_parameters("sphere");
  p.input = "gallery:teapot";
  session.start(p);
  const SessionSnapshot s = settled(session);
  CHECK(s.phase == SessionPhase::failed);
  REQUIRE(s.error);
  CHECK(s.error->code == ErrorCode::bad_input);
  session.start(gallery_parameters("sphere"));
  CHECK(settled(session).phase == SessionPhase::finished);
  CHECK(!session.snapshot().error);
}

TEST_CASE("A soup of one's own is run in place of the input") {
  auto soup = load_input(gallery_parameters("sphere"));
  REQUIRE(soup.ok());
  soup->name = "mine";
  RunParameters p = gallery_parameters("torus");
  Session session;
  session.start(p, std::make_shared<const TriangleSoup>(*soup));
  const SessionSnapshot s = settled(session);
  CHECK(s.scene->input->name == "mine");
  CHECK(s.result->certificate.euler_characteristic == 2);
}

TEST_CASE("A watcher may seek and look at any state while the run goes on") {
  Session session;
  session.start(quick("torus"));
  const auto journal = session.snapshot().journal;
  std::atomic<bool> done{false};
  std::thread watcher([&] {
    Playback playback(journal);
    std::uint64_t random = 7;
    while (!done) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      const Step steps = journal->steps();
      const Step step = (random >> 40) % 2 == 0 ? steps : static_cast<Step>((random >> 33) % (steps + 1));
      const auto state = make_snapshot(playback, step, {}, nullptr);
      const bool judged = state->samples && state->complex.form != ZeroForm::free;
      if (state->errors.size() != (judged ? state->samples->size() : 0)) std::abort();
    }
  });
  const SessionSnapshot s = settled(session);
  done = true;
  watcher.join();
  CHECK(s.phase == SessionPhase::finished);
  CHECK(s.result->certificate.holds());
}
