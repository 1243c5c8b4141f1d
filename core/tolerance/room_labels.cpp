// Numbers rooms breadth first, and looks at both sides of every wall for fins.
#include "tolerance/room_labels.h"

#include "base/parallel.h"
#include "base/place.h"
#include "tolerance/delta_study.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>

namespace isoscope {
namespace {

constexpr int most_rooms = std::numeric_limits<std::int8_t>::max();
/// Both sides of walls are looked at this far from them, in units of δ', at places about so many δ apart, but
/// at no more of them than this.
constexpr double wall_reach = 1.2, probe_spacing = 2;
constexpr std::size_t most_probes = 100000, probes_per_task = 256;

/// Places spread over the triangles, each with its triangle: at least one in each.
struct WallProbe {
  TriangleId triangle;
  Vec3 point;
};
std::vector<WallProbe> probes_on_walls(const ClosestPointIndex& index, double spacing) {
  double area = 0;
  for (std::size_t i = 0; i < index.size(); ++i) area += isoscope::area(index.triangle(TriangleId(i)));
  const double share = std::max(spacing * spacing, area / most_probes);
  std::vector<WallProbe> probes;
  for (std::size_t i = 0; i < index.size(); ++i) {
    const Triangle3& t = index.triangle(TriangleId(i));
    // n² equal parts, each asked at its middle: the upright ones and those between them.
    const auto n = static_cast<int>(std::ceil(std::sqrt(isoscope::area(t) / share)));
    const Vec3 u = (t[1] - t[0]) / std::max(n, 1), v = (t[2] - t[0]) / std::max(n, 1);
    for (int a = 0; a < n; ++a)
      for (int b = 0; a + b < n; ++b) {
        const Vec3 corner = t[0] + double(a) * u + double(b) * v;
        probes.push_back({TriangleId(i), corner + (u + v) / 3});
        if (a + b + 1 < n) probes.push_back({TriangleId(i), corner + 2.0 / 3 * (u + v)});
      }
  }
  return probes;
}

/// Numbers the deep regions; 0 stays with the others.
class RoomNumbers {
 public:
  explicit RoomNumbers(const ToleranceVolume& volume)
      : regions_(volume.regions()), labels_(regions_.size(), 0), around_(volume.volume_component_count()),
        components_(regions_.size()), enough_(deep_enough * volume.thresholds().delta) {
    for (const BoundaryComponent& c : volume.boundary_components()) {
      if (!is_deep(c.region)) continue;
      around_[c.volume_component].push_back(c.region);
      components_[c.region.index()].push_back(c.volume_component);
    }
  }

  Result<std::vector<int>> number() {
    std::deque<RegionId> queue{RegionId(0)};
    labels_[0] = +1;
    while (!queue.empty()) {
      const RegionId from = queue.front();
      queue.pop_front();
      for (const std::uint32_t c : components_[from.index()])
        for (const RegionId to : around_[c]) {
          if (labels_[to.index()] != 0) continue;
          labels_[to.index()] = around_[c].size() == 2 && labels_[from.index()] < 0 ? +1 : free_room(c);
          if (labels_[to.index()] < -most_rooms) return too_many(to);
          queue.push_back(to);
        }
    }
    // What no wall leads to lies beside one that the octree does not see.
    for (const Region& r : regions_)
      if (labels_[r.id.index()] == 0 && is_deep(r.id)) labels_[r.id.index()] = -1;
    return std::move(labels_);
  }

 private:
  bool is_deep(RegionId r) const {
    const Region& region = regions_[r.index()];
    return region.unbounded || region.depth > enough_;
  }
  /// The first number that no region beside a component of Ω' has.
  int free_room(std::uint32_t component) const {
    int label = -1;
    const auto taken = [&](RegionId r) { return labels_[r.index()] == label; };
    while (std::any_of(around_[component].begin(), around_[component].end(), taken)) --label;
    return label;
  }
  Error too_many(RegionId r) const {
    return {ErrorCode::unsupported,
            "More than " + std::to_string(most_rooms) + " rooms share walls, one of them around " +
                place(regions_[r.index()].deepest, place_digits) + ".",
            "Split the input where rooms do not touch each other, or choose a larger tolerance, which closes "
            "small ones."};
  }

  std::span<const Region> regions_;
  std::vector<int> labels_;
  std::vector<std::vector<RegionId>> around_;          ///< deep regions by component of Ω'
  std::vector<std::vector<std::uint32_t>> components_; ///< and the other way round
  double enough_;
};

} // namespace

std::optional<Vec3> one_sided_wall(const ToleranceVolume& volume, std::optional<std::uint32_t> component,
                                   const RunControl& control) {
  const ClosestPointIndex& index = volume.index();
  const double boundary = volume.thresholds().boundary;
  const std::vector<WallProbe> probes = probes_on_walls(index, probe_spacing * volume.thresholds().delta);
  std::vector<std::uint8_t> fin(probes.size(), 0);
  parallel_until(probes.size(), probes_per_task, control, [&](std::size_t i) {
    if (component && volume.volume_component(probes[i].triangle) != *component) return;
    const Triangle3& t = index.triangle(probes[i].triangle);
    const Vec3 n = normalized(cross(t[1] - t[0], t[2] - t[0]));
    if (n == Vec3{}) return;
    const auto region = [&](double reach) {
      const Vec3 p = probes[i].point + reach * boundary * n;
      const ClosestPoint closest = index.closest(p);
      return closest.distance() > boundary ? volume.escape(p, closest).region : RegionId();
    };
    const RegionId above = region(wall_reach);
    fin[i] = above.valid() && region(-wall_reach) == above;
  });
  const auto found = std::find(fin.begin(), fin.end(), 1);
  if (found == fin.end()) return std::nullopt;
  return probes[static_cast<std::size_t>(found - fin.begin())].point;
}

Result<DepthLabels> label_rooms(const ToleranceVolume& volume, const RunControl& control) {
  auto labels = RoomNumbers(volume).number();
  if (!labels) return labels.error();
  const bool rooms = *std::min_element(labels->begin(), labels->end()) < -1;
  if (const auto fin = rooms ? one_sided_wall(volume, {}, control) : std::nullopt)
    return Error{ErrorCode::joined_sheets,
                 "A wall ends in the open near " + place(*fin, place_digits) +
                     ": one region is on both sides of it, and rooms cannot have fins.",
                 "Remove what stands out there."};
  return spread_labels(volume, std::move(*labels), control);
}

} // namespace isoscope
