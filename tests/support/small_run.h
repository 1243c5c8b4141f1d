// A small finished run for tests of what watches runs.
#pragma once

#include "run/session.h"

namespace isoscope {

/// Runs a bundled sphere at a coarse δ to its end; the session owns the journal.
inline SessionSnapshot small_run(Session& session) {
  RunParameters parameters;
  parameters.input = "gallery:sphere";
  parameters.tolerance = {12, true};
  session.start(parameters);
  session.wait_until_settled(120);
  return session.snapshot();
}

} // namespace isoscope
