// What every certified run of an open surface has.
#pragma once

#include "run/complete_run.h"

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <utility>

namespace isoscope::test {

/// A run on a sheet that has to end; what it does not certify is told.
inline std::unique_ptr<CompleteRun> finished_run(RunParameters parameters, TriangleSoup soup) {
  auto run = std::make_unique<CompleteRun>(std::move(parameters));
  run->soup = std::make_shared<const TriangleSoup>(std::move(soup));
  const bool done = run->run();
  if (run->error) MESSAGE(run->error->line());
  REQUIRE(done);
  for (const std::string& failure : run->result->certificate.failures) MESSAGE(failure);
  return run;
}

inline void check_certified(const CompleteRun& run, long chi, std::size_t loops, std::size_t components = 1) {
  const Certificate& c = run.result->certificate;
  INFO(c.topology_note);
  CHECK(c.holds());
  CHECK(c.euler_characteristic == chi);
  CHECK(c.boundary_loops == loops);
  CHECK(c.components == components);
  CHECK(c.topology == Certificate::Topology::as_expected);
  REQUIRE(c.border.has_value());
  CHECK(c.border->to_rim <= run.scene->delta);
  CHECK(c.border->from_rim <= run.scene->delta);
}

} // namespace isoscope::test
