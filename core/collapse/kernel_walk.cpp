// Hit and run with a generator of its own: the standard distributions differ between libraries.
#include "collapse/kernel_walk.h"

#include "base/scramble.h"

#include <algorithm>

namespace isoscope {

namespace {

/// SplitMix64 [Steele et al. 2014].
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// In [0, 1).
  double uniform() {
    state_ += golden_step;
    return static_cast<double>(scrambled(state_) >> 11) * 0x1p-53;
  }
  /// Uniform on the unit sphere.
  Vec3 direction() {
    for (;;) {
      const double x = 2 * uniform() - 1, y = 2 * uniform() - 1, z = 2 * uniform() - 1;
      const double l = x * x + y * y + z * z;
      if (l > 1e-4 && l <= 1) return Vec3{x, y, z} / std::sqrt(l);
    }
  }

 private:
  std::uint64_t state_;
};

} // namespace

std::vector<Vec3> walk_kernel(std::span<const HalfSpace> half_spaces, Vec3 start, int n, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> slack;
  for (const HalfSpace& h : half_spaces) slack.push_back(h.slack(start));
  std::vector<double> along(slack.size());
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(n));
  Vec3 offset; // from the start
  for (int i = 0; i < n; ++i) {
    const Vec3 direction = random.direction();
    double lo = -Box3::inf, hi = Box3::inf;
    for (std::size_t k = 0; k < slack.size(); ++k) {
      along[k] = dot(half_spaces[k].normal, direction);
      const double room = std::max(slack[k], 0.0);
      if (along[k] > 0) {
        lo = std::max(lo, -room / along[k]);
      } else if (along[k] < 0) {
        hi = std::min(hi, -room / along[k]);
      }
    }
    const double t = lo + random.uniform() * (hi - lo);
    if (!std::isfinite(t)) break;
    offset += t * direction;
    for (std::size_t k = 0; k < slack.size(); ++k) slack[k] += t * along[k];
    points.push_back(start + offset);
  }
  return points;
}

} // namespace isoscope
