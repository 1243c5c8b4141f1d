// Whole powers by squaring: the p-norms of the improver ask for millions of them.
#pragma once

namespace isoscope {

/// x^p for p >= 0.
inline double integer_power(double x, int p) {
  double result = 1;
  for (; p > 0; p >>= 1, x *= x)
    if (p & 1) result *= x;
  return result;
}

} // namespace isoscope
