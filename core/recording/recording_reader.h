// Reads a recording, whole, cut short by a kill, or still growing, into a journal.
#pragma once

#include "base/status.h"
#include "journal/journal.h"
#include "recording/layout.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace isoscope {

class Database;

/// An open recording; used by one thread at a time. Everything is checked against the checksums of the
/// commits: a damaged file gives what is sound before the damage, then an error.
class RecordingReader {
 public:
  /// Fails with bad_input on a file that is missing, foreign, damaged or holds no input yet, with unsupported
  /// on one of a newer version, with io when it cannot be read.
  static Result<std::unique_ptr<RecordingReader>> open(const std::filesystem::path& file);
  /// The same for a database that nobody else uses; `file` is what messages call it.
  static Result<std::unique_ptr<RecordingReader>> over(Database database, const std::filesystem::path& file);
  /// Goes on in another state of the same recording, also after an error, which another state may not have;
  /// false where that ends before what was read. Fails with usage where it holds another run, and as it must
  /// where it cannot be read.
  Result<bool> go_on_in(Database database);
  ~RecordingReader();

  const RecordingHeader& header() const;
  std::uint64_t input_digest() const;
  std::uint64_t file_bytes() const;

  /// Appends the next commit to the journal, which must have been filled by this reader alone; false when
  /// there is none yet. Fails with bad_input where the file is damaged.
  Result<bool> read_commit(Journal& journal);
  /// Appends what lies behind the last commit that was read, event by event, up to the first that is missing
  /// or makes no sense. No checksum proves it.
  void read_unproven(Journal& journal);
  /// Rows of events with this number or a higher one.
  std::size_t events_behind(std::size_t event);
  /// How the run ended; nothing while it has not, or when it was cut short.
  Result<std::optional<RecordingEnd>> end();
  /// Whether a program is still writing it (or another one follows it). When nobody is, the write-ahead log
  /// that a killed writer left is taken into the file.
  bool growing();

 private:
  struct Impl;
  explicit RecordingReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Whether the name ends in .isorun.
bool is_recording_name(const std::filesystem::path& file);

} // namespace isoscope
