// How old a copy of a recording is, and what is said of one that is followed.
#pragma once

#include "run/session.h"

#include <optional>
#include <string>

namespace isoscope {

/// Seconds since it was written; nothing where there is no copy. Where its clock is ahead of ours, 0.
std::optional<double> age_of(const RecordingState& recording);

/// "40 s", "12 min", "3 h", "2 days"
std::string age_text(double seconds);

/// "follows torus.isorun 1.2 MB, 12 s old", with what is not there yet.
std::string copy_text(const RecordingState& recording, SessionPhase phase);

} // namespace isoscope
