// One run of isoscope-run as a process of its own, under limits, measured.
#pragma once

#include "corpus/corpus_table.h"

#include <filesystem>

namespace isoscope::corpus {

struct Limits {
  double cpu_seconds = 300; ///< after which it is a hang
  double memory_mb = 8192;  ///< of address space; 0: no limit, as sanitizers need it
};

/// Runs `program` on a model with one thread and without recording; a file for the report is made in
/// `folder`. What it does to itself, killed by a limit or not, is in the row.
Row run_one(const std::filesystem::path& program, const std::filesystem::path& model, const Asked& asked,
            const Limits& limits, const std::filesystem::path& folder);

} // namespace isoscope::corpus
