// A whole recording in memory, as replay and diff read it.
#pragma once

#include "recording/recording_reader.h"
#include "run/parameters.h"

#include <memory>
#include <optional>
#include <string>

namespace isoscope {

/// A recording with its journal up to the last commit.
struct RecordedRun {
  std::unique_ptr<RecordingReader> reader;
  RunParameters parameters;
  std::shared_ptr<Journal> journal = std::make_shared<Journal>();
  std::optional<RecordingEnd> end; ///< absent where the run ended without finishing
};

/// Fails with io or bad_input on a file that is missing, foreign or damaged.
Result<RecordedRun> read_recorded_run(const std::string& file);
} // namespace isoscope
