// The JSON report of a run: one object with fixed keys.
#pragma once

#include "run/pipeline.h"
#include "run/statistics.h"

#include <filesystem>
#include <string>

namespace isoscope {

/// The report's text, indented, ending in a newline. Keys as in the README; the program's version included.
std::string report_json(const RunParameters& parameters, const Scene& scene, const RunResult& result,
                        const std::vector<StageStatistics>& stages);
/// Writes through a temporary file in the same folder (devices and pipes directly); fails with io on a full
/// disk.
Status write_text_file(const std::filesystem::path& file, const std::string& text);

/// "finished", "stopped" or "time limit".
std::string_view name(RunResult::End end);
/// "0.1.0"
std::string_view version();

} // namespace isoscope
