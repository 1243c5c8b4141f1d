// What every certified run of an open surface has.
#pragma once

#include "run/complete_run.h"

#include <doctest/doctest.h>

namespace isoscope::test {

inline void check_certified(const CompleteRun& run, long chi, std::size_t loops, std::size_t components = 1) {
  const Certificate& c = run.result->certificate;
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
