// A run and its recording: what goes into the file besides the journal, and what comes out of it.
#pragma once

#include "recording/layout.h"
#include "run/pipeline.h"

#include <memory>

namespace isoscope {

/// For a run that begins with these parameters on this input.
RecordingHeader recording_header(const RunParameters& parameters, std::shared_ptr<const TriangleSoup> input,
                                 std::vector<InputNote> notes = {});
/// For a run that has ended: its report and certificate.
RecordingEnd recording_end(const RunParameters& parameters, const Scene& scene, const RunResult& result,
                           const Journal& journal);

/// Ω and all that was known before the first operation, made again from the stored input; S is the
/// recording's own. Fails as Pipeline::prepare() does.
Result<std::shared_ptr<const Scene>> rebuild_scene(const RunParameters& parameters,
                                                   std::shared_ptr<const TriangleSoup> input,
                                                   const Journal& journal, RunControl& control,
                                                   std::vector<InputNote> notes = {});
/// The state after the last operation.
Complex final_state(const Journal& journal);
/// How the recorded run ended, Z from the journal, the certificate from the report. Fails with bad_input.
Result<RunResult> recorded_result(const RecordingEnd& end, const Journal& journal);

} // namespace isoscope
