// The reader of recordings: whole files, and behind the checksums the codecs. The first byte says which.
#include "fuzz/target.h"
#include "input/temporary_folder.h"
#include "journal/digest.h"
#include "journal/synthetic.h"
#include "recording/bytes.h"
#include "recording/delta_codec.h"
#include "recording/geometry_codec.h"
#include "recording/recording_reader.h"
#include "recording/recording_writer.h"
#include "recording/salvage.h"

#include <memory>

namespace isoscope::fuzz {

namespace {

namespace fs = std::filesystem;

constexpr char whole = 'W', delta = 'D', soup = 'T', samples = 'S';

const TemporaryFolder& folder() {
  static const TemporaryFolder made;
  return made;
}

std::shared_ptr<const Journal> recorded() {
  static const std::shared_ptr<const Journal> made = [] {
    auto journal = std::make_shared<Journal>();
    test::record_insertions(*journal, 12, 40, 5);
    return journal;
  }();
  return made;
}

TriangleSoup small_soup() {
  TriangleSoup made;
  made.name = "seed";
  made.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  made.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return made;
}

/// All deltas in their order, each behind its length.
std::string deltas() {
  DeltaEncoder encoder;
  ByteWriter out;
  for (std::size_t i = 0; i < recorded()->operations().size(); ++i) {
    const std::string_view bytes = encoder.encode(recorded()->operations()[i].delta());
    out.number(bytes.size());
    for (const char byte : bytes) out.byte(static_cast<std::uint8_t>(byte));
  }
  return out.take();
}

std::string recording(bool finished) {
  const fs::path file = folder() / "seed.isorun";
  auto writer = RecordingWriter::create(file, {std::chrono::milliseconds(1), 5});
  require(writer.ok(), "the seed could not be made");
  (*writer)->start({"isoscope", "{}", std::make_shared<TriangleSoup>(small_soup())}, recorded());
  if (finished) (*writer)->end([] { return RecordingEnd{"finished", true, "{\"vertices\": 4}"}; });
  require((*writer)->finish().ok(), "the seed could not be written");
  return bytes_of(file);
}

std::vector<std::string> seeds() {
  return {whole + recording(true), whole + recording(false), soup + encode(small_soup()),
          samples + encode(*test::sphere_samples(30, 3)), delta + deltas()};
}

/// Digests of the journal up to each event.
const std::vector<std::uint64_t>& prefixes() {
  static const std::vector<std::uint64_t> made = [] {
    Digest digest;
    std::vector<std::uint64_t> values{digest.value()};
    for (std::size_t i = 0; i < recorded()->events().size(); ++i) {
      digest.add(recorded()->events()[i]);
      values.push_back(digest.value());
    }
    return values;
  }();
  return made;
}

/// Of the journal's first `count` events.
std::uint64_t digest_of(const Journal& journal, std::size_t count) {
  Digest digest;
  for (std::size_t i = 0; i < count; ++i) digest.add(journal.events()[i]);
  return digest.value();
}

/// What is saved of the same bytes and called proven is what was written.
void check_salvage(const fs::path& file) {
  const auto saved = salvage_recording(file);
  if (!saved) {
    require(saved.error().code != ErrorCode::internal, "the salvage blames itself");
    return;
  }
  require(saved->proven <= saved->journal->events().size(), "more is proven than there is");
  require(saved->proven < prefixes().size(), "proven events that nobody wrote");
  require(digest_of(*saved->journal, saved->proven) == prefixes()[saved->proven],
          "proven events that nobody wrote so");
}

bool accepts_recording(std::string_view bytes) {
  const fs::path file = folder().file("m.isorun", bytes);
  bool sound = false;
  check_salvage(file);
  {
    auto reader = RecordingReader::open(file);
    if (reader) {
      Journal journal;
      Result<bool> more = true;
      while (more && *more) more = (*reader)->read_commit(journal);
      require(journal.events().size() < prefixes().size(), "events that nobody wrote");
      const std::size_t count = journal.events().size();
      require(digest_of(journal, count) == prefixes()[count], "events that nobody wrote so");
      const auto end = (*reader)->end();
      sound = more.ok() && end.ok();
    } else {
      require(reader.error().code != ErrorCode::internal, "the reader blames itself");
      require(!reader.error().remedy.empty(), "an error without a remedy");
    }
  }
  for (const char* left : {"-wal", "-shm", "-journal"}) fs::remove(file.string() + left);
  return sound;
}

bool accepts_deltas(std::string_view bytes) {
  DeltaDecoder decoder;
  ByteReader in(bytes);
  Delta read;
  while (!in.exhausted()) {
    std::string one;
    for (std::uint64_t left = in.number(); left > 0 && !in.failed(); --left)
      one.push_back(static_cast<char>(in.byte()));
    if (in.failed() || !decoder.decode(one, read)) return false;
  }
  return true;
}

bool accepts_soup(std::string_view bytes) {
  const auto read = decode_soup(bytes);
  if (!read) return false;
  for (const Vec3 p : read->points) require(is_finite(p), "a coordinate that is not finite");
  for (const auto& t : read->triangles)
    for (const auto v : t) require(v < read->points.size(), "a corner out of range");
  return true;
}

bool accepts_samples(std::string_view bytes) {
  const auto read = decode_samples(bytes);
  if (!read) return false;
  require(read->labels.size() == read->positions.size() && read->components.size() == read->positions.size(),
          "samples without labels or components");
  return true;
}

bool accepts(std::string_view bytes) {
  if (bytes.empty()) return false;
  const std::string_view rest = bytes.substr(1);
  switch (bytes.front()) {
  case whole:
    return accepts_recording(rest);
  case delta:
    return accepts_deltas(rest);
  case soup:
    return accepts_soup(rest);
  case samples:
    return accepts_samples(rest);
  default:
    return false;
  }
}

} // namespace

const Target& target() {
  static const Target made{
      "recording", seeds,   {"SQLite format 3", "commits", "\xff\xff\xff\xff\x7f", "{", "0"},
      accepts,     4 << 20, 1500};
  return made;
}

} // namespace isoscope::fuzz
