// Numbers in words: what rounds to zero has no sign.
#include "base/numbers.h"

#include <doctest/doctest.h>

using namespace isoscope;

TEST_CASE("what rounds to zero has no sign, what does not keeps it") {
  CHECK(fixed(-0.04, 1) == "0.0");
  CHECK(fixed(-0.0, 2) == "0.00");
  CHECK(fixed(-0.4, 0) == "0");
  CHECK(fixed(0.04, 1) == "0.0");
  CHECK(fixed(-0.06, 1) == "-0.1");
  CHECK(fixed(-10, 0) == "-10");
  CHECK(fixed(-100.04, 1) == "-100.0");
}
