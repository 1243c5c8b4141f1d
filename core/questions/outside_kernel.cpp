// The kernel itself decides; the half-space with the least slack is named.
#include "questions/outside_kernel.h"

#include <algorithm>

namespace isoscope {

std::vector<OutsidePoint> points_outside(const EdgeXray& xray) {
  std::vector<OutsidePoint> found;
  const auto& kernel = xray.attempt.kernel;
  if (!kernel || kernel->empty || kernel->half_spaces.empty()) return found;
  const auto look = [&](OutsidePoint::What what, Vec3 p) {
    if (kernel->contains(p)) return;
    const auto worst =
        std::min_element(kernel->half_spaces.begin(), kernel->half_spaces.end(),
                         [&](const HalfSpace& a, const HalfSpace& b) { return a.slack(p) < b.slack(p); });
    found.push_back({what, p, std::max(-worst->slack(p), 0.0),
                     static_cast<std::uint32_t>(worst - kernel->half_spaces.begin())});
  };
  look(OutsidePoint::What::kept_end, xray.star.vertices[0].position);
  look(OutsidePoint::What::removed_end, xray.star.vertices[1].position);
  if (!xray.halfedge) look(OutsidePoint::What::least_error, xray.attempt.optimum);
  return found;
}

} // namespace isoscope
