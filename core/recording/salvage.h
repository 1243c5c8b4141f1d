// What can be saved of a recording that is damaged or cut short.
#pragma once

#include "base/status.h"
#include "journal/journal.h"
#include "recording/layout.h"
#include "tolerance/boundary_sampler.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace isoscope {

/// What is made or read again stands in for what is damaged: the two largest things that a file holds.
/// Checksums tell whether it is the same.
struct SalvageSubstitutes {
  std::shared_ptr<const TriangleSoup> input;
  std::shared_ptr<const BoundarySamples> samples; ///< the first set
};

/// The beginning of a recorded run, up to the first event that is missing or makes no sense.
struct Salvage {
  RecordingHeader header; ///< without input where that is damaged; nothing else is there then
  std::shared_ptr<Journal> journal = std::make_shared<Journal>();
  /// So many events are what was recorded, by the checksum of their commit. Those behind them are rows that
  /// were found and fit together, which changed bytes in them may do too.
  std::size_t proven = 0;
  std::size_t rows_behind = 0;     ///< rows of events that were found behind the last one of the journal
  std::optional<RecordingEnd> end; ///< when nothing is missing and the run had ended
  std::string damage;              ///< the first that was found, in words; empty for none
};

/// Reads the file's pages one by one, and its write-ahead log's where there is one, and leaves both alone.
/// Fails with bad_input where nothing of a recording is found, and with io when the file cannot be read.
Result<Salvage> salvage_recording(const std::filesystem::path& file,
                                  const SalvageSubstitutes& substitutes = {});

} // namespace isoscope
