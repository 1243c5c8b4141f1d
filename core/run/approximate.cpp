// The pipeline with nobody who watches or steers.
#include "run/approximate.h"

#include "base/parallel.h"
#include "run/passing_gate.h"

#include <utility>

namespace isoscope {

Result<Approximation> approximate(TriangleSoup soup, const RunParameters& parameters, RunControl& control) {
  const ThreadLimit threads(parameters.threads);
  auto journal = std::make_shared<Journal>();
  journal->keep_within(usual_history_mib << 20);
  PassingGate gate;
  Pipeline pipeline(parameters, journal, gate, control);
  const auto scene = pipeline.prepare(std::make_shared<const TriangleSoup>(std::move(soup)));
  if (!scene) return scene.error();
  auto result = pipeline.run();
  if (!result) return result.error();
  return Approximation{std::move(*result), *scene, journal};
}

} // namespace isoscope
