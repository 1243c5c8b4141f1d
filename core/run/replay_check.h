// Runs a recording again from its input and compares every event, delta and state (core/README.md, D1).
#pragma once

#include "run/pipeline.h"

#include <memory>
#include <string>

namespace isoscope {

/// What a check found.
struct ReplayVerdict {
  bool same = true;
  std::size_t events = 0;     ///< compared, in order, to the first difference
  std::size_t operations = 0; ///< of them; their deltas were compared bit for bit
  std::size_t states = 0;     ///< whose digest came back when the operations were undone
  bool to_the_end = false;    ///< the final Z, too, is the one the new run ended with
  std::string difference;     ///< the first one, in words; empty when same
  Step step = 0;              ///< at which it is
};

/// Runs `parameters` on `input`, of which reading told `notes`, and compares with the recorded journal;
/// `ended`: the recorded run came to its end, so that its final Z is compared too. Parameters that were
/// changed during the run are changed at the same event. States are compared at every operation while they
/// are small, and so often that the cost stays linear in the work of the operations. Fails as a run does.
Result<ReplayVerdict> check_replay(const RunParameters& parameters, std::shared_ptr<const TriangleSoup> input,
                                   const Journal& recorded, bool ended, RunControl& control,
                                   std::vector<InputNote> notes = {});

/// Compares two runs of the same that have both ended: every event, text, repair and delta; then the states
/// between the recorded operations, forth and back.
ReplayVerdict compare_journals(const Journal& recorded, const Journal& again);

} // namespace isoscope
