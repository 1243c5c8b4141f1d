// Tessellates and cuts with a journal that nobody reads.
#include "run/trial_cut.h"

#include "collapse/live_complex.h"
#include "journal/stage_log.h"
#include "mesh/zero_set.h"
#include "run/passing_gate.h"
#include "simplify/rim_cut.h"
#include "simplify/tessellation.h"

namespace isoscope {

bool is_tried(const ToleranceVolume& volume, const ExpectedTopology& expected) {
  const InputTopology& input = volume.input();
  return volume.open_sides() != nullptr && !volume.open_sides()->by_samples() && input.manifold &&
         expected.euler_characteristic == input.euler_characteristic &&
         expected.components == input.components && expected.boundary_loops == input.boundary_loops;
}

TopologyVerdict try_cut(const Complex& refined, const ToleranceVolume& volume,
                        const ExpectedTopology& expected, const RunControl& control) {
  const Result<Delta> delta = mutual_tessellation(refined);
  if (!delta) return {};
  LiveComplex live(refined, nullptr);
  live.apply(*delta);
  Journal journal;
  PassingGate gate;
  Recorder recorder(journal, gate);
  StageLog log(recorder, control);
  log.begin(Stage::rim);
  if (!RimCut(live, volume, log).run().ok() || log.stopped()) return {};
  return check_topology(extract_zero_set(live.complex()), expected);
}

} // namespace isoscope
