// A recording that grows elsewhere, seen through copies that are late and torn: what is shown is always a
// beginning of the run, and in the end the whole of it.
#include "input/temporary_folder.h"
#include "journal/synthetic.h"
#include "recording/copy_reader.h"
#include "recording/recorded.h"
#include "run/recorded_run.h"
#include "run/session.h"
#include "support/eventually.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <random>
#include <thread>

using namespace isoscope;
using namespace isoscope::test;

namespace {

namespace fs = std::filesystem;

std::string text_of_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

fs::path log_of(const fs::path& file) {
  return file.string() + "-wal";
}

/// What carries a file and its log from one folder to another, well or badly.
class Transport {
 public:
  Transport(fs::path from, fs::path to, std::uint32_t seed)
      : from_(std::move(from)), to_(std::move(to)), random_(seed) {}

  /// Everything, with no log where there is none any more.
  void whole() const {
    carry(from_, to_);
    carry(log_of(from_), log_of(to_));
  }

  void something() {
    switch (number(9)) {
    case 0:
      whole();
      break;
    case 1: // each is of another moment
      carry(log_of(from_), log_of(to_));
      break;
    case 2:
      carry(from_, to_);
      break;
    case 3: // cut off anywhere
      write_bytes(to_, cut(text_of_file(from_)));
      break;
    case 4:
      write_bytes(log_of(to_), cut(text_of_file(log_of(from_))));
      break;
    case 5: // written over in place, as far as it came
      write_bytes(to_, mixed(text_of_file(from_), text_of_file(to_)));
      break;
    case 6:
      write_bytes(log_of(to_), mixed(text_of_file(log_of(from_)), text_of_file(log_of(to_))));
      break;
    case 7: // a hole, as of a block that has not come
      write_bytes(to_, holed(text_of_file(from_)));
      break;
    default:
      fs::remove(number(2) == 0 ? to_ : log_of(to_));
    }
  }

 private:
  std::size_t number(std::size_t below) { return below == 0 ? 0 : random_() % below; }
  /// By a file beside it and a rename.
  static void carry(const fs::path& from, const fs::path& to) {
    if (!fs::exists(from)) {
      fs::remove(to);
      return;
    }
    write_bytes(to.string() + ".tmp", text_of_file(from));
    fs::rename(to.string() + ".tmp", to);
  }
  std::string cut(std::string bytes) {
    bytes.resize(number(bytes.size() + 1));
    return bytes;
  }
  std::string mixed(const std::string& newer, const std::string& older) {
    const std::size_t at = number(newer.size() + 1);
    return newer.substr(0, at) + (at < older.size() ? older.substr(at) : "");
  }
  std::string holed(std::string bytes) {
    const std::size_t at = number(bytes.size() + 1), size = std::min(bytes.size() - at, number(20000));
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), size, '\0');
    return bytes;
  }

  fs::path from_, to_;
  std::mt19937 random_;
};

} // namespace

TEST_CASE("Whatever the copy is like, what is read of it is a beginning of the run") {
  for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
    CAPTURE(seed);
    const TemporaryFolder folder;
    const fs::path there = folder / "there.isorun", here = folder / "here.isorun";
    auto journal = std::make_shared<Journal>();
    auto writer = RecordingWriter::create(there, {std::chrono::milliseconds(1), 40});
    REQUIRE(writer.ok());
    (*writer)->start(recording_header(whole_run().parameters, whole_run().scene->input), journal);
    Transport transport(there, here, seed);
    CopyReader reader(here);
    Journal read;
    const RunControl control;
    std::size_t grew = 0;
    const auto look = [&] {
      const std::size_t before = read.events().size();
      const auto looked = reader.look(read, control);
      REQUIRE(looked.ok());
      CHECK(read.events().size() >= before);
      check_prefix(read, *journal);
      grew += read.events().size() > before ? 1 : 0;
    };
    look(); // there is nothing yet
    CHECK(reader.header() == nullptr);
    CHECK_FALSE(reader.written().has_value());
    record_insertions(*journal, 300, 300, seed, [&] {
      transport.something();
      look();
    });
    CHECK(grew > 2);
    (*writer)->end([] { return RecordingEnd{"stopped", false, "{}"}; });
    REQUIRE((*writer)->finish().ok());
    writer->reset();
    for (int i = 0; i < 30; ++i) {
      transport.something();
      look();
    }
    transport.whole();
    look();
    check_same(read, *journal);
    REQUIRE(reader.end().has_value());
    CHECK(reader.end()->state == "stopped");
    CHECK_FALSE(reader.torn().has_value());
    CHECK(reader.bytes() == fs::file_size(here));
    // Nothing is left beside the copy.
    CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 2);
    CHECK(text_of_file(here) == text_of_file(there));
  }
}

TEST_CASE("A log that stays behind does not hide the end") {
  const TemporaryFolder folder;
  const fs::path there = folder / "there.isorun", here = folder / "here.isorun";
  auto journal = std::make_shared<Journal>();
  auto writer = RecordingWriter::create(there, {std::chrono::milliseconds(1), 40});
  REQUIRE(writer.ok());
  (*writer)->start(recording_header(whole_run().parameters, whole_run().scene->input), journal);
  record_insertions(*journal, 100, 300, 9);
  REQUIRE(eventually([&] { return (*writer)->progress().events == journal->events().size(); }));
  write_bytes(log_of(here), text_of_file(log_of(there)));
  record_insertions(*journal, 200, 300, 9);
  (*writer)->end([] { return RecordingEnd{"finished", true, "{}"}; });
  REQUIRE((*writer)->finish().ok());
  REQUIRE_FALSE(fs::exists(log_of(there)));
  write_bytes(here, text_of_file(there));
  CopyReader reader(here);
  Journal read;
  CHECK(*reader.look(read, RunControl()));
  check_same(read, *journal);
  CHECK(reader.end().has_value());
  CHECK_FALSE(*reader.look(read, RunControl())); // there is nothing new
  // It is opened as any file, too, and the log does no harm to it.
  const ReadBack back = read_back(here);
  CHECK_FALSE(back.error.has_value());
  CHECK(back.end.has_value());
  check_same(*back.journal, *journal);
  CHECK(text_of_file(here) == text_of_file(there));
}

TEST_CASE("A copy that becomes that of another run is told, and nothing is taken back") {
  const TemporaryFolder folder;
  const fs::path here = folder / "here.isorun";
  auto one = std::make_shared<Journal>(), other = std::make_shared<Journal>();
  record_insertions(*one, 60, 300, 1);
  record_insertions(*other, 90, 300, 2);
  REQUIRE(write_recording(folder / "one.isorun", one, false, 20).ok());
  REQUIRE(write_recording(folder / "other.isorun", other, false, 20).ok());
  write_bytes(here, text_of_file(folder / "one.isorun"));
  CopyReader reader(here);
  Journal read;
  REQUIRE(reader.look(read, RunControl()).ok());
  check_same(read, *one);
  CHECK_FALSE(reader.end().has_value());
  write_bytes(here, text_of_file(folder / "other.isorun"));
  const auto looked = reader.look(read, RunControl());
  REQUIRE_FALSE(looked.ok());
  CHECK(looked.error().message.find("another run") != std::string::npos);
  check_same(read, *one);
}

TEST_CASE("A session waits for a copy, follows it, and ends with the run") {
  const TemporaryFolder folder;
  const CompleteRun& run = whole_run();
  const fs::path there = folder / "there.isorun", here = folder / "here.isorun";
  REQUIRE(write_recording(there, run.journal, true, 10).ok());
  const std::string whole = text_of_file(there);
  Session session;
  session.follow_copy(here);
  REQUIRE(eventually([&] { return session.snapshot().recording.has_value(); }));
  const std::uint64_t generation = session.snapshot().generation;
  CHECK(session.snapshot().phase == SessionPhase::preparing);
  // The head alone, then all but its end, then a hole in the middle.
  write_bytes(here, whole.substr(0, 5000));
  REQUIRE(eventually([&] { return session.snapshot().recording->bytes == 5000; }));
  REQUIRE(eventually([&] { return session.snapshot().recording->torn.has_value(); }));
  std::string holed = whole;
  std::fill(holed.begin() + static_cast<std::ptrdiff_t>(holed.size() / 2), holed.end(), '\0');
  write_bytes(here, holed);
  REQUIRE(eventually([&] { return session.snapshot().recording->bytes == holed.size(); }));
  CHECK(session.snapshot().phase != SessionPhase::failed);
  write_bytes(here, whole);
  REQUIRE(session.wait_until_settled(60));
  const SessionSnapshot s = session.snapshot();
  CHECK(s.phase == SessionPhase::finished);
  CHECK(s.generation == generation);
  check_same(*s.journal, *run.journal);
  REQUIRE(s.result != nullptr);
  CHECK(s.result->certificate.holds());
  CHECK_FALSE(s.recording->cut_short);
  CHECK_FALSE(s.recording->torn.has_value());
  CHECK(s.recording->written.has_value());
  // Nobody wants more of one that goes no further.
  write_bytes(folder / "part.isorun", holed);
  session.follow_copy(folder / "part.isorun");
  REQUIRE(eventually([&] { return session.snapshot().phase == SessionPhase::following; }));
  session.stop();
  REQUIRE(session.wait_until_settled(60));
  CHECK(session.snapshot().phase == SessionPhase::finished);
  CHECK(session.snapshot().recording->cut_short);
  // Nor of one that never came.
  session.follow_copy(folder / "never.isorun");
  session.stop();
  REQUIRE(session.wait_until_settled(60));
  CHECK(session.snapshot().phase == SessionPhase::failed);
  CHECK(session.snapshot().error->message.find("has not come") != std::string::npos);
}

TEST_CASE("Folders of this machine are not elsewhere") {
  const TemporaryFolder folder;
  CHECK_FALSE(lies_elsewhere(folder / "not-there.isorun"));
}
