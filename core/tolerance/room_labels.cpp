// Numbers rooms breadth first, and looks at both sides of every wall for fins.
#include "tolerance/room_labels.h"

#include "base/parallel.h"
#include "base/place.h"
#include "tolerance/delta_study.h"
#include "tolerance/wall_neighbours.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <string>

namespace isoscope {
namespace {

constexpr int most_rooms = std::numeric_limits<std::int8_t>::max();
constexpr std::size_t probes_per_task = 256;

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
  const std::vector<WallProbe> probes = probes_on_walls(volume);
  std::vector<std::uint8_t> fin(probes.size(), 0);
  parallel_until(probes.size(), probes_per_task, control, [&](std::size_t i) {
    if (!component || volume.volume_component(probes[i].triangle) == *component)
      fin[i] = neighbours_of_wall(volume, probes[i]).ends_in_the_open();
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
