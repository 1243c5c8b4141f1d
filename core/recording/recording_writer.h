// Follows a growing journal from a thread of its own and commits it to a file (core/README.md, D8).
#pragma once

#include "base/status.h"
#include "journal/journal.h"
#include "recording/layout.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace isoscope {

/// How far a recording is.
struct RecordingProgress {
  std::filesystem::path file;
  std::uint64_t bytes = 0;    ///< on the disk
  std::size_t events = 0;     ///< committed
  std::optional<Error> error; ///< nothing is written after it; what was committed is safe
};

/// A recording that is being written. The run never waits for it: when the disk is full the run goes on and
/// progress() tells. A killed program leaves everything up to the last commit.
class RecordingWriter {
 public:
  struct Options {
    std::chrono::milliseconds interval{200}; ///< between commits
    std::size_t events_per_commit = 20000;   ///< at most
  };

  /// Makes the file with its empty tables. An older recording of that name is replaced, unless a program is
  /// using it; any other file is left alone. Fails with io or usage.
  static Result<std::unique_ptr<RecordingWriter>> create(const std::filesystem::path& file, Options options);
  static Result<std::unique_ptr<RecordingWriter>> create(const std::filesystem::path& file);
  /// Finishes; takes the file away again when the writer was never started.
  ~RecordingWriter();

  /// Writes the header and everything that the journal has, then follows it.
  void start(RecordingHeader header, std::shared_ptr<const Journal> journal);
  bool started() const;
  /// The run has ended with the events that the journal has now. `describe` is called on the writer's thread.
  /// A run that goes on afterwards is followed again.
  void end(std::function<RecordingEnd()> describe);
  /// Writes what is left and closes the file; the error that kept it from being complete, if any.
  Status finish();
  RecordingProgress progress() const;

 private:
  struct Impl;
  explicit RecordingWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
