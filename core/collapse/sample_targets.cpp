// A grid over the samples.
#include "collapse/sample_targets.h"

#include <algorithm>
#include <cmath>

namespace isoscope {

namespace {

constexpr double cell_size = 4; ///< in σ

} // namespace

SampleTargets::SampleTargets(const BoundarySamples& samples)
    : samples_(samples), size_(cell_size * samples.sigma) {
  for (std::size_t i = 0; i < samples.size(); ++i)
    cells_[cell_of(samples.labels[i], samples.positions[i])].push_back(static_cast<std::uint32_t>(i));
}

SampleTargets::Cell SampleTargets::cell_of(int label, Vec3 p) const {
  const auto along = [this](double x) { return static_cast<std::int32_t>(std::floor(x / size_)); };
  return {label, along(p.x), along(p.y), along(p.z)};
}

std::vector<Vec3> SampleTargets::near(const EdgeStar& star) const {
  Box3 box;
  for (const auto& v : star.vertices) box.add(v.position);
  const int label = star.vertices[0].label();
  std::vector<std::uint32_t> found;
  const auto in_box = [&](Vec3 p) {
    return p.x >= box.lo.x && p.x <= box.hi.x && p.y >= box.lo.y && p.y <= box.hi.y && p.z >= box.lo.z &&
           p.z <= box.hi.z;
  };
  const Cell lo = cell_of(label, box.lo), hi = cell_of(label, box.hi);
  for (std::int32_t x = lo[1]; x <= hi[1]; ++x) {
    for (std::int32_t y = lo[2]; y <= hi[2]; ++y) {
      const Cell last{label, x, y, hi[3]};
      for (auto at = cells_.lower_bound({label, x, y, lo[3]}); at != cells_.end() && at->first <= last;
           ++at) {
        for (const std::uint32_t s : at->second) {
          if (in_box(samples_.positions[s])) found.push_back(s);
        }
      }
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<Vec3> points;
  points.reserve(found.size());
  for (const std::uint32_t s : found) points.push_back(samples_.positions[s]);
  return points;
}

} // namespace isoscope
