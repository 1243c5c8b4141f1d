// Neighbours by distance, and the site by its point.
#include "questions/point_questions.h"

#include "tolerance/weighted_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isoscope {
namespace {

/// The `count` nearest, those at the same distance by number.
std::vector<std::uint32_t> nearest_points(const std::vector<Vec3>& points, std::uint32_t of,
                                          std::size_t count) {
  std::vector<std::pair<double, std::uint32_t>> by_distance(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
    by_distance[i] = {squared_length(points[i] - points[of]), i};
  by_distance[of].first = -1; // before what is at the same place
  count = std::min(count, points.size());
  const auto end = by_distance.begin() + static_cast<std::ptrdiff_t>(count);
  std::partial_sort(by_distance.begin(), end, by_distance.end());
  std::vector<std::uint32_t> nearest;
  for (auto it = by_distance.begin(); it != end; ++it) nearest.push_back(it->second);
  return nearest;
}

std::optional<std::uint32_t> site_of(const PointField& field, std::uint32_t point) {
  if (field.point.empty()) return point;
  const auto at = std::lower_bound(field.point.begin(), field.point.end(), point);
  if (at == field.point.end() || *at != point) return std::nullopt;
  return static_cast<std::uint32_t>(at - field.point.begin());
}

} // namespace

double PointInspection::ball_radius(double delta) const {
  return kept && weight < delta * delta ? std::sqrt(delta * delta - weight) : 0;
}

std::optional<PointInspection> inspect_point(const Scene& scene, std::uint32_t point) {
  if (!scene.points || !scene.field || scene.field->kind() != FieldKind::points) return std::nullopt;
  const PointField& field = *scene.points;
  const std::vector<Vec3>& points = field.points->points;
  if (point >= points.size()) return std::nullopt;
  PointInspection found;
  found.position = points[point];
  found.neighbors = nearest_points(points, point, field.neighbors);
  found.phi = scene.field->distance(found.position);
  if (const auto site = site_of(field, point)) {
    const auto& index = static_cast<const WeightedPointIndex&>(*scene.field);
    found.mean = index.site(TriangleId(*site)).center;
    found.weight = index.site(TriangleId(*site)).weight;
    return found;
  }
  const auto k = static_cast<double>(found.neighbors.size());
  for (const std::uint32_t i : found.neighbors) found.mean += points[i] / k;
  for (const std::uint32_t i : found.neighbors) found.weight += squared_length(points[i] - found.mean) / k;
  found.kept = false;
  if (found.weight < scene.delta * scene.delta) found.dropped = DroppedPoints::Why::blob;
  return found;
}

} // namespace isoscope
