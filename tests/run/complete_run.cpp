// Runs the pipeline step by step, keeping what comes out.
#include "run/complete_run.h"

#include "input/gallery.h"

namespace isoscope::test {

CompleteRun::CompleteRun(TriangleSoup input, double delta)
    : soup(std::make_shared<const TriangleSoup>(std::move(input))) {
  parameters.tolerance = {delta, false};
}

bool CompleteRun::prepare() {
  pipeline = std::make_unique<Pipeline>(parameters, journal, gate, control);
  auto prepared = pipeline->prepare(soup, notes);
  if (!prepared) {
    error = prepared.error();
    return false;
  }
  scene = *prepared;
  gate.wanted = parameters.criteria(scene->delta);
  return true;
}

bool CompleteRun::run() {
  if (!scene && !prepare()) return false;
  auto finished = pipeline->run();
  if (!finished) {
    error = finished.error();
    return false;
  }
  result = std::move(*finished);
  return true;
}

RunParameters gallery_parameters(const std::string& name) {
  RunParameters parameters;
  parameters.input = "gallery:" + name;
  for (const GalleryEntry& entry : gallery()) {
    if (entry.name != name) continue;
    if (!entry.gives_volume()) parameters.tolerance = {entry.tolerance_percent, true};
    parameters.levels = {entry.low, entry.high};
  }
  parameters.until = Stage::refinement;
  return parameters;
}

RunParameters complete_parameters(const std::string& name) {
  RunParameters parameters = gallery_parameters(name);
  parameters.until.reset();
  return parameters;
}

Complex replayed(const Journal& journal) {
  Complex complex;
  for (std::size_t k = 0; k < journal.operations().size(); ++k)
    complex.apply(journal.operations()[k].delta());
  return complex;
}

} // namespace isoscope::test
