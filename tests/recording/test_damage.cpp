// Files that are no recordings, or no longer: every one gives a clear error, and what is sound is read.
#include "input/temporary_folder.h"
#include "journal/synthetic.h"
#include "recording/recorded.h"
#include "run/parameters_json.h"
#include "run/recorded_run.h"
#include "support/mutations.h"

#include <sqlite3.h>

#include <doctest/doctest.h>

#include <random>

#include <unistd.h>

using namespace isoscope;
using namespace isoscope::test;

namespace {

namespace fs = std::filesystem;

void change(const fs::path& file, const char* statements) {
  sqlite3* connection = nullptr;
  REQUIRE(sqlite3_open(file.c_str(), &connection) == SQLITE_OK);
  CHECK(sqlite3_exec(connection, statements, nullptr, nullptr, nullptr) == SQLITE_OK);
  sqlite3_close(connection);
}

void check_refused(const fs::path& file, const std::string& why, ErrorCode code = ErrorCode::bad_input) {
  const ReadBack back = read_back(file);
  CAPTURE(file);
  REQUIRE(back.error.has_value());
  CAPTURE(back.error->line());
  CHECK(back.error->code == code);
  CHECK(back.error->message.find(why) != std::string::npos);
  CHECK(!back.error->remedy.empty());
}

} // namespace

TEST_CASE("Foreign, missing and empty files are told apart") {
  const TemporaryFolder folder;
  check_refused(folder / "missing.isorun", "does not exist");
  check_refused(folder.path(), "no plain file");
  check_refused(folder.file("empty.isorun", ""), "is empty");
  check_refused(folder.file("mesh.isorun", "OFF\n8 12 0\n"), "begins with other bytes");
  change(folder / "other.isorun", "CREATE TABLE t(x)");
  check_refused(folder / "other.isorun", "another program");
  check_refused(folder.file("cut.isorun", "SQLite format 3\0 and no more"), "is not a recording");
}

TEST_CASE("Another version is told, with what to do") {
  const TemporaryFolder folder;
  const auto file = folder / "other.isorun";
  REQUIRE(write_recording(file, small_journal(), false).ok());
  change(file, "PRAGMA user_version=99");
  check_refused(file, "newer version", ErrorCode::unsupported);
  change(file, "PRAGMA user_version=1");
  check_refused(file, "older version", ErrorCode::unsupported);
}

TEST_CASE("A recording without an input says that the run never began") {
  const TemporaryFolder folder;
  const auto file = folder / "early.isorun";
  REQUIRE(write_recording(file, small_journal(), false).ok());
  change(file, "DELETE FROM input");
  check_refused(file, "before the run began");
}

TEST_CASE("Rows that are changed, missing or out of range are found") {
  const TemporaryFolder folder;
  const auto journal = small_journal();
  for (const char* statement :
       {"UPDATE event_rows SET value=value+1 WHERE id=120", "UPDATE event_rows SET kind=99 WHERE id=120",
        "DELETE FROM event_rows WHERE id=120", "DELETE FROM operations WHERE step=110",
        "UPDATE operations SET delta=x'00' WHERE step=110",
        "UPDATE operations SET tets=tets+1 WHERE step=110", "UPDATE sample_sets SET data=x'0102' WHERE id=1",
        "UPDATE commits SET checksum='0' WHERE events>100", "UPDATE criteria SET alpha=0.9 WHERE id=1"}) {
    const auto file = folder / "changed.isorun";
    REQUIRE(write_recording(file, journal, false, 50).ok());
    change(file, statement);
    CAPTURE(statement);
    const ReadBack back = read_back(file);
    REQUIRE(back.error.has_value());
    CHECK(back.error->code == ErrorCode::bad_input);
    CHECK(back.error->message.find("damaged") != std::string::npos);
    CHECK(back.error->remedy.find("are sound") != std::string::npos);
    // What lies before the damage is there, and nothing of what lies behind.
    check_prefix(*back.journal, *journal);
    CHECK(back.journal->events().size() < journal->events().size());
    REQUIRE(back.reader);
    CHECK(!back.reader->read_commit(*back.journal).ok());
  }
  const auto file = folder / "changed.isorun";
  REQUIRE(write_recording(file, journal, false, 50).ok());
  change(file, "UPDATE input SET data=substr(data,1,100)");
  check_refused(file, "input does not match");
}

TEST_CASE("Flipped bits are found, or touch nothing that is read") {
  const TemporaryFolder folder;
  const auto journal = small_journal();
  const auto whole = folder / "whole.isorun";
  REQUIRE(write_recording(whole, journal, false, 50).ok());
  const std::string bytes = bytes_of(whole);
  std::mt19937_64 random(17);
  int found = 0; // most others hit what no reader reads: free space, names, comments
  for (int round = 0; round < 150; ++round) {
    std::string damaged = bytes;
    const std::size_t at = random() % damaged.size();
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
    const auto file = folder.file("flipped.isorun", damaged);
    const ReadBack back = read_back(file);
    found += back.error.has_value() ? 1 : 0;
    check_prefix(*back.journal, *journal);
    if (!back.error) CHECK(back.journal->events().size() <= journal->events().size());
  }
  CHECK(found > 50);
}

TEST_CASE("A whole run in a file that was damaged in several places is read soundly or refused") {
  const TemporaryFolder folder;
  const Journal& journal = *whole_run().journal;
  const auto whole = folder / "whole.isorun";
  REQUIRE(write_recording(whole, whole_run().journal, true, 200).ok());
  const std::string bytes = bytes_of(whole);
  Draws draws(23);
  int refused = 0;
  for (int round = 0; round < 200; ++round) {
    const ReadBack back = read_back(folder.file("damaged.isorun", damaged(bytes, draws)));
    check_prefix(*back.journal, journal);
    if (!back.reader) {
      ++refused;
      continue;
    }
    const auto parameters = parse_parameters(back.reader->header().parameters);
    refused += back.error || !parameters;
    if (!back.end) continue;
    const auto result = recorded_result(*back.end, *back.journal);
    if (result) CHECK(result->mesh.triangles.size() <= whole_run().result->mesh.triangles.size());
  }
  CHECK(refused > 100);
}

TEST_CASE("Files that are cut short are found") {
  const TemporaryFolder folder;
  const auto journal = small_journal();
  const auto whole = folder / "whole.isorun";
  REQUIRE(write_recording(whole, journal, false, 50).ok());
  const std::string bytes = bytes_of(whole);
  for (int part = 0; part < 16; ++part) {
    const ReadBack back = read_back(folder.file("cut.isorun", bytes.substr(0, bytes.size() * part / 16)));
    CHECK(back.error.has_value());
    check_prefix(*back.journal, *journal);
  }
}

TEST_CASE("Places where nothing can be written are told") {
  const TemporaryFolder folder;
  const auto journal = small_journal();
  const auto refused = [&](const fs::path& file, const std::string& why) {
    const Status written = write_recording(file, journal, false);
    CAPTURE(file);
    REQUIRE(!written.ok());
    CAPTURE(written.error().line());
    CHECK(written.error().message.find(why) != std::string::npos);
    CHECK(!written.error().remedy.empty());
  };
  refused(folder / "no folder" / "a.isorun", "folder");
  refused(folder.path(), "is a folder");
  const auto mesh = folder.file("mesh.off", "OFF\n0 0 0\n");
  refused(mesh, "is not a recording");
  CHECK(bytes_of(mesh) == "OFF\n0 0 0\n");
  if (geteuid() == 0) return; // for whom every folder is writable
  fs::create_directory(folder / "locked");
  fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  refused(folder / "locked" / "a.isorun", "not writable");
  fs::permissions(folder / "locked", fs::perms::owner_all);
}

TEST_CASE("An older recording is replaced, one in use is not") {
  const TemporaryFolder folder;
  const auto journal = small_journal();
  const auto file = folder / "a.isorun";
  REQUIRE(write_recording(file, journal, false).ok());
  REQUIRE(write_recording(file, journal, false).ok());
  auto writer = RecordingWriter::create(file);
  REQUIRE(writer.ok());
  const auto second = RecordingWriter::create(file);
  REQUIRE(!second.ok());
  CHECK(second.error().message.find("in use") != std::string::npos);
  // A writer that was never started leaves nothing.
  writer->reset();
  CHECK(!fs::exists(file));
}
