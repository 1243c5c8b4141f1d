// Reads a copy of a recording that grows elsewhere, as whatever carries it here leaves it: late, cut off, in
// the middle of a commit, its log older or newer than itself.
#pragma once

#include "base/run_control.h"
#include "journal/journal.h"
#include "recording/recording_reader.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace isoscope {

/// Whether a file lies on another machine, as its file system tells: locks of that one mean nothing here.
bool lies_elsewhere(const std::filesystem::path& file);

/// Only reads, takes no lock, and leaves no file beside the copy; used by one thread at a time. What it
/// appends is proven by the checksums of commits, so that the journal is a beginning of the run at any time.
class CopyReader {
 public:
  explicit CopyReader(std::filesystem::path file);
  ~CopyReader();

  /// Appends what there is to the journal, which must have been filled by this reader alone. Looks at no byte
  /// where nothing has changed. True when there was something new. Fails with usage where the copy is now
  /// that of another run, and with unsupported where it is of another version: nothing can be read on then.
  Result<bool> look(Journal& journal, const RunControl& control);

  /// Null until the copy has held the run's beginning.
  const RecordingHeader* header() const;
  /// How the run ended, once all its events are read.
  const std::optional<RecordingEnd>& end() const;
  /// Why the last look ended before the copy does; nothing where it is sound.
  const std::optional<Error>& torn() const;
  /// Of the copy and its log.
  std::uint64_t bytes() const;
  /// When the newest of them was last written; nothing while there is none. What carries it here may keep the
  /// time of the other machine.
  std::optional<std::chrono::system_clock::time_point> written() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
