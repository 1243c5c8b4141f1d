// Searches of a hierarchy of segments.
#include "tolerance/segment_index.h"

#include "tolerance/box_search.h"
#include "tolerance/bvh_builder.h"

#include <utility>

namespace isoscope {

SegmentIndex::SegmentIndex(std::vector<Segment3> segments) : segments_(std::move(segments)) {
  std::vector<Box3> boxes(segments_.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (const Vec3 p : segments_[i]) boxes[i].add(p);
  BvhBuilder(boxes_, std::move(boxes), nullptr, BvhBuilder::large_leaf).build();
}

ClosestOnSegments SegmentIndex::closest(Vec3 p) const {
  const ClosestPoint found = search_boxes(
      boxes_, p, ClosestPoint{}, 0, [](std::uint32_t) { return Lanes{}; },
      [&](std::uint32_t first, std::uint32_t count, ClosestPoint& best) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          const std::uint32_t id = boxes_.ids[slot];
          const Vec3 point = point_on(segments_[id], closest_on_segment(p, segments_[id]));
          const double squared = squared_length(p - point);
          if (squared < best.squared_distance) best = {point, squared, TriangleId(id)};
        }
      });
  if (!found.triangle.valid()) return {};
  return {found.point, found.distance(), static_cast<std::uint32_t>(found.triangle.index())};
}

std::vector<std::uint32_t> SegmentIndex::near(Vec3 center, double r) const {
  std::vector<std::uint32_t> found;
  const double reach = r + ChildDistances::margin(boxes_, center);
  visit_boxes(
      boxes_, center, [&](const auto&, unsigned, double squared) { return squared <= reach * reach; },
      [&](std::uint32_t first, std::uint32_t count) {
        found.insert(found.end(), boxes_.ids.begin() + first, boxes_.ids.begin() + first + count);
        return true;
      });
  std::sort(found.begin(), found.end());
  return found;
}

} // namespace isoscope
