// Damaged recordings: what the pages still hold is saved, and never more than was recorded.
#include "input/temporary_folder.h"
#include "journal/digest.h"
#include "journal/synthetic.h"
#include "recording/recorded.h"
#include "recording/salvage.h"

#include <sqlite3.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <thread>

using namespace isoscope;
using namespace isoscope::test;

namespace {

namespace fs = std::filesystem;

/// What checksums prove is what was recorded; returns how many events were saved, 0 where nothing could be.
std::size_t check_salvage(const fs::path& file, const Journal& whole) {
  const auto found = salvage_recording(file);
  if (!found) {
    CHECK(found.error().code == ErrorCode::bad_input);
    CHECK(!found.error().remedy.empty());
    return 0;
  }
  if (!found->header.input) return 0;
  CHECK(found->proven <= found->journal->events().size());
  CHECK(found->journal->events().size() <= whole.events().size());
  check_prefix(*first_events(*found->journal, found->proven), whole);
  return found->journal->events().size();
}

} // namespace

TEST_CASE("a sound recording is saved whole, with its end") {
  const TemporaryFolder folder;
  const CompleteRun& run = whole_run();
  const auto file = folder / "whole.isorun";
  REQUIRE(write_recording(file, run.journal, true, 200).ok());
  const std::string before = bytes_of(file);
  const auto found = salvage_recording(file);
  REQUIRE(found.ok());
  CHECK(digest(*found->journal) == digest(*run.journal));
  check_same(*found->journal, *run.journal);
  CHECK(found->proven == run.journal->events().size());
  CHECK(found->rows_behind == 0);
  CHECK(found->damage.empty());
  REQUIRE(found->end.has_value());
  CHECK(found->end->state == "finished");
  CHECK(found->header.input->points == run.scene->input->points);
  CHECK(bytes_of(file) == before);
}

TEST_CASE("a file cut anywhere gives a beginning, and the longer the file the more of it") {
  const TemporaryFolder folder;
  const auto journal = small_journal();
  const auto whole = folder / "whole.isorun";
  REQUIRE(write_recording(whole, journal, false, 50).ok());
  const std::string bytes = bytes_of(whole);
  std::size_t last = 0, gave = 0;
  for (std::size_t part = 1; part <= 40; ++part) {
    const std::size_t size = bytes.size() * part / 40;
    const std::size_t saved = check_salvage(folder.file("cut.isorun", bytes.substr(0, size)), *journal);
    CHECK(saved >= last);
    gave += saved > 0;
    last = saved;
  }
  CHECK(last == journal->events().size());
  CHECK(gave >= 10);
}

TEST_CASE("damage of any page hides no event before it, and a head in ruins hides none at all") {
  const TemporaryFolder folder;
  const auto journal = small_journal();
  const auto whole = folder / "whole.isorun";
  REQUIRE(write_recording(whole, journal, false, 50).ok());
  const std::string bytes = bytes_of(whole);
  std::string headless = bytes;
  std::fill_n(headless.begin(), 100, '\xee');
  CHECK(check_salvage(folder.file("headless.isorun", headless), *journal) == journal->events().size());
  std::size_t most = 0;
  for (std::size_t page = 0; page < bytes.size() / 4096; ++page) {
    std::string damaged = bytes;
    std::fill_n(damaged.begin() + static_cast<std::ptrdiff_t>(page * 4096), 4096, '\0');
    most = std::max(most, check_salvage(folder.file("damaged.isorun", damaged), *journal));
  }
  CHECK(most == journal->events().size()); // pages of names
}

TEST_CASE("a damaged input and damaged samples are replaced by the same ones, and by no others") {
  const TemporaryFolder folder;
  const CompleteRun& run = whole_run();
  const auto file = folder / "whole.isorun";
  REQUIRE(write_recording(file, run.journal, true, 200).ok());
  const auto spoil = [&](const char* statement) {
    sqlite3* connection = nullptr;
    REQUIRE(sqlite3_open(file.c_str(), &connection) == SQLITE_OK);
    CHECK(sqlite3_exec(connection, statement, nullptr, nullptr, nullptr) == SQLITE_OK);
    sqlite3_close(connection);
  };
  spoil("UPDATE input SET data=zeroblob(length(data)); UPDATE sample_sets SET data=zeroblob(length(data))");
  const auto lost = salvage_recording(file);
  REQUIRE(lost.ok());
  CHECK(!lost->header.input);
  CHECK(!lost->header.parameters.empty());
  TriangleSoup other = *run.scene->input;
  other.points.front().x += 1;
  CHECK(!salvage_recording(file, {std::make_shared<const TriangleSoup>(other), nullptr})->header.input);
  const auto input = salvage_recording(file, {run.scene->input, nullptr});
  REQUIRE(input.ok());
  CHECK(input->header.input->points == run.scene->input->points);
  CHECK(input->proven == 0);
  const auto both = salvage_recording(file, {run.scene->input, run.scene->samples});
  REQUIRE(both.ok());
  CHECK(both->proven == run.journal->events().size());
  check_same(*both->journal, *run.journal);
}

TEST_CASE("changed bytes are never taken for what was recorded") {
  const TemporaryFolder folder;
  const Journal& journal = *whole_run().journal;
  const auto whole = folder / "whole.isorun";
  REQUIRE(write_recording(whole, whole_run().journal, true, 200).ok());
  const std::string bytes = bytes_of(whole);
  std::mt19937_64 random(31);
  std::size_t saved = 0;
  for (int round = 0; round < 120; ++round) {
    std::string damaged = bytes;
    for (std::size_t i = 0, n = 1 + random() % 4; i < n; ++i) {
      const std::size_t at = random() % damaged.size(),
                        length = std::min<std::size_t>(1 + random() % 64, damaged.size() - at);
      if (random() % 2 == 0)
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
      else
        std::fill_n(damaged.begin() + static_cast<std::ptrdiff_t>(at), length, static_cast<char>(random()));
    }
    saved += check_salvage(folder.file("damaged.isorun", damaged), journal) > 0;
  }
  CHECK(saved > 30);
}

TEST_CASE("the write-ahead log of a killed writer counts, and a damaged frame of it harms nothing before") {
  const TemporaryFolder folder;
  const auto journal = small_journal();
  const auto file = folder / "open.isorun";
  const CompleteRun& run = whole_run();
  auto writer = RecordingWriter::create(file, {std::chrono::milliseconds(1), 50});
  REQUIRE(writer.ok());
  RecordingHeader header{"isoscope", "{}", run.scene->input};
  (*writer)->start(header, journal);
  while ((*writer)->progress().events < journal->events().size()) std::this_thread::yield();
  // What a kill would leave: the files as they are while the writer has them open.
  const std::string main = bytes_of(file), log = bytes_of(file.string() + "-wal");
  REQUIRE((*writer)->finish().ok());
  REQUIRE(log.size() > 4096);
  const auto killed = folder.file("killed.isorun", main);
  folder.file("killed.isorun-wal", log);
  CHECK(check_salvage(killed, *journal) == journal->events().size());
  CHECK(bytes_of(killed) == main);
  for (std::size_t part = 1; part < 8; ++part) {
    std::string damaged = log;
    damaged[log.size() * part / 8] = static_cast<char>(damaged[log.size() * part / 8] ^ 64);
    folder.file("killed.isorun-wal", damaged);
    check_salvage(killed, *journal);
    folder.file("killed.isorun-wal", log.substr(0, log.size() * part / 8));
    check_salvage(killed, *journal);
  }
  fs::remove(folder / "killed.isorun-wal");
  check_salvage(killed, *journal);
}

TEST_CASE("what is no recording gives a word") {
  const TemporaryFolder folder;
  const Journal nothing;
  for (const std::string& bytes :
       {std::string(), std::string("OFF\n8 12 0\n"), std::string(100000, '\x0d'), std::string(50000, '\xff')})
    CHECK(check_salvage(folder.file("foreign.isorun", bytes), nothing) == 0);
  CHECK(check_salvage(folder / "missing.isorun", nothing) == 0);
  CHECK(check_salvage(folder.path(), nothing) == 0);
}
