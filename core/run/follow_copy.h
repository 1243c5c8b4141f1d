// A copy of a recording shown as if it were a run, while it grows on another machine.
#pragma once

#include "run/show_recording.h"

namespace isoscope {

/// Waits for the copy, reads on whenever there is more of it, and leaves the phase `finished` once the run's
/// end is there or nobody wants more. What is torn is waited for; it never takes back what is shown. Fails as
/// rebuild_scene() does, and where the copy becomes that of another run.
Status follow_copy(const std::filesystem::path& file, const std::shared_ptr<Journal>& journal,
                   RunControl& control, const RecordingAudience& audience);

} // namespace isoscope
