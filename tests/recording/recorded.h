// Small runs and their recordings, for tests.
#pragma once

#include "recording/recording_reader.h"
#include "recording/recording_writer.h"
#include "run/complete_run.h"

#include <filesystem>
#include <memory>

namespace isoscope::test {

/// A whole run of a bundled model, made once a program.
const CompleteRun& whole_run();
/// 150 insertions.
std::shared_ptr<const Journal> small_journal();
/// Writes a journal to a file in commits of at most so many events; `finished`: with its ending.
Status write_recording(const std::filesystem::path& file, std::shared_ptr<const Journal> journal,
                       bool finished, std::size_t events_per_commit = 100);
/// Everything that can be read, and the error that ended it, if any.
struct ReadBack {
  std::unique_ptr<RecordingReader> reader;
  std::shared_ptr<Journal> journal = std::make_shared<Journal>();
  std::optional<RecordingEnd> end;
  std::optional<Error> error;
};
ReadBack read_back(const std::filesystem::path& file);
/// Everything but times: the digest, the figures, the parameters.
void check_same(const Journal& a, const Journal& b);
/// The first of `read` are those of `whole`.
void check_prefix(const Journal& read, const Journal& whole);

} // namespace isoscope::test
