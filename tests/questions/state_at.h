// The state of a complete run at a step, as questions get it.
#pragma once

#include "journal/playback.h"
#include "questions/snapshot.h"
#include "run/complete_run.h"

#include <memory>

namespace isoscope::test {

inline std::shared_ptr<const StateSnapshot> state_at(const CompleteRun& run, Step step) {
  Playback playback(run.journal);
  return make_snapshot(playback, step, {}, nullptr);
}

} // namespace isoscope::test
