// Numbers beside their limits have as many digits as tell the two apart.
#include "model/words.h"

#include <doctest/doctest.h>

using namespace isoscope;

TEST_CASE("a number beside its limit does not read as the limit") {
  CHECK(number_beside(1.00012, 1) == "1.0001");
  CHECK(number_beside(0.99998, 1) == "0.99998"); // four digits would be 1.0000, as 1.000 is
  CHECK(number_beside(0.9999, 1) == "0.9999");
  CHECK(number_beside(0.7870, 0.8) == "0.7870");
  CHECK(number_beside(0.79996, 0.8) == "0.79996");
  CHECK(number_beside(1, 1) == "1.000");
  CHECK(number_beside(12345.2, 12345) == "12345.2000");
}

TEST_CASE("what arithmetic leaves of a zero is zero beside its limit") {
  CHECK(number_beside(-8.88e-16, 0.8) == "0.0000");
  CHECK(number_beside(-0.0004, 0.8) == "-0.0004");
  CHECK(number_beside(4.08e-18, 2.09e-18) == "4.08e-18");
  CHECK(number_beside(-3e-18, 0) == "-3.00e-18");
}
