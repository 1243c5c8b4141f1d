// The cone of targets that keep a sample inside a tetrahedron, cut by where its class is wrong.
#include "criteria/invalid_region.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {

bool InvalidRegion::contains(Vec3 x) const {
  if (empty()) return false;
  if (ball && squared_length(x - ball->center) >= ball->radius * ball->radius) return false;
  return std::all_of(half_spaces.begin(), half_spaces.end(),
                     [x](const HalfSpace& h) { return h.slack(x) >= 0; });
}

bool InvalidRegion::contains_box(const Box3& box) const {
  if (empty() || box.empty()) return false;
  const auto corner = [&box](Vec3 direction) {
    return Vec3{direction.x > 0 ? box.hi.x : box.lo.x, direction.y > 0 ? box.hi.y : box.lo.y,
                direction.z > 0 ? box.hi.z : box.lo.z};
  };
  if (ball &&
      squared_length(corner(box.center() - ball->center) - ball->center) >= ball->radius * ball->radius)
    return false;
  return std::all_of(half_spaces.begin(), half_spaces.end(),
                     [&](const HalfSpace& h) { return h.slack(corner(-h.normal)) >= 0; });
}

InvalidRegion invalid_region(const EdgeStar& star, const EdgeStar::StarTet& tet,
                             const EdgeStar::StarSample& sample, double target_value, double margin) {
  InvalidRegion region;
  region.tet = tet.id;
  region.sample = sample.id;
  if (star.form == ZeroForm::embedded && tet.side == sample.label) return region;

  const Vec3 e = sample.position;
  std::array<Vec3, 3> ray{}; // E − A, E − B, E − C
  std::array<double, 3> deficit{};
  std::size_t n = 0;
  for (const std::uint16_t v : tet.v) {
    if (v < 2) continue;
    ray[n] = e - star.vertices[v].position;
    deficit[n] = margin - seen_from(sample.label, star.vertices[v].value, star.vertices[v].label());
    ++n;
  }
  const double volume = dot(ray[0], cross(ray[1], ray[2]));
  const double scale = std::max({length(ray[0]), length(ray[1]), length(ray[2])});
  if (!(std::abs(volume) > 1e-14 * scale * scale * scale)) return region;

  // The coordinates x, y, z are linear in T − E: dual[k]·(T − E).
  std::array<Vec3, 3> dual{};
  for (std::size_t k = 0; k < 3; ++k) {
    dual[k] = cross(ray[(k + 1) % 3], ray[(k + 2) % 3]) / volume;
    const Vec3 normal = normalized(dual[k]);
    region.half_spaces.push_back({normal, dot(normal, e)});
  }
  if (star.form == ZeroForm::embedded) return region;

  const Vec3 g = deficit[0] * dual[0] + deficit[1] * dual[1] + deficit[2] * dual[2];
  const std::int8_t target_label = label_of(target_value, star.vertices[0].room);
  const double target_deficit = margin - seen_from(sample.label, target_value, target_label);
  const double l = length(g);
  // Σ deficit·coordinate + target_deficit >= 0
  if (l > 0) {
    region.half_spaces.push_back({g / l, dot(g, e) / l - target_deficit / l});
  } else if (target_deficit < 0) {
    region.half_spaces.clear();
  }
  return region;
}

InvalidRegion invalid_region(Vec3 target, double weight, double excess) {
  InvalidRegion region;
  region.ball = {target, std::max(excess, 0.0) / weight};
  return region;
}

} // namespace isoscope
