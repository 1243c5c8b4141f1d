// Sines and cosines that have the same bits on every machine, made of additions and multiplications only.
#pragma once

namespace isoscope {

/// A point of the unit circle.
struct CirclePoint {
  double cosine, sine;
};

/// The point at k/n of a full turn, k any integer, n > 0. The library's sin and cos may differ in the last
/// bit between machines, and the journal of a run would with them; here the eight octants are also exact
/// mirror images.
CirclePoint circle_point(long k, long n);

} // namespace isoscope
