// What isoscope-run says when a run has ended.
#pragma once

#include "run/pipeline.h"
#include "run/statistics.h"

#include <string>
#include <vector>

namespace isoscope {

/// A few lines for a person: input, samples, stages, the mesh, the certificate. `stopped_at`: what stopped
/// the run where it was no person, "breakpoint 2 (...)"; empty else.
std::string summary(const RunParameters& parameters, const Scene& scene, const RunResult& result,
                    const std::vector<StageStatistics>& stages, const std::string& stopped_at = {});

/// What of it nobody may miss, for those who do not see it: that the run was stopped, what the certificate
/// lacks and where, what Ω closed. Empty where a run finished, is certified and lost nothing. `stop_told`:
/// why it was stopped is known already.
std::vector<std::string> warnings(const RunParameters& parameters, const Scene& scene,
                                  const RunResult& result, bool stop_told = false);

/// Whether the run would be faster from another first Z, as far as is known; empty where not.
std::string start_note(const RunParameters& parameters, const Scene& scene);

} // namespace isoscope
