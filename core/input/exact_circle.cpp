// Taylor series on an eighth of a turn, mirrored to the other seven.
#include "input/exact_circle.h"

#include <utility>

namespace isoscope {

CirclePoint circle_point(long k, long n) {
  k = ((k % n) + n) % n;
  const long octant = 8 * k / n;
  // The angle from the nearest multiple of a quarter turn, in 1/(8n) of a turn: within one octant.
  const long quarter = (octant + 1) / 2;
  const long part = 8 * k - 2 * quarter * n;
  const double angle =
      6.283185307179586476925 * static_cast<double>(part < 0 ? -part : part) / (8.0 * static_cast<double>(n));
  const double square = angle * angle;
  double cosine = 1, sine = 1;
  for (int i = 22; i >= 2; i -= 2) { // Horner: 1 - x²/(1·2) (1 - x²/(3·4) (...))
    cosine = 1 - square / (i * (i - 1)) * cosine;
    sine = 1 - square / (i * (i + 1)) * sine;
  }
  sine *= part < 0 ? -angle : angle;
  switch (quarter % 4) {
  case 0:
    return {cosine, sine};
  case 1:
    return {-sine, cosine};
  case 2:
    return {-cosine, -sine};
  default:
    return {sine, -cosine};
  }
}

} // namespace isoscope
