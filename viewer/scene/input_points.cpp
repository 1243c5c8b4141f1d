// What each point of a field counts for.
#include "scene/input_points.h"

#include "tolerance/weighted_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {
namespace {

/// Blue to yellow through grey, as cividis: even in brightness, and apart from good and bad samples.
constexpr std::array<std::uint32_t, 5> on_dark{0x4A7BC8, 0x7488A6, 0xA09A82, 0xD0B95C, 0xFFE94A};
constexpr std::array<std::uint32_t, 5> on_light{0xB09A3A, 0x8F8868, 0x6E7480, 0x48598A, 0x1B3A7A};

} // namespace

std::shared_ptr<const InputPoints> input_points(const Scene& scene) {
  if (!scene.points || !scene.field || scene.field->kind() != FieldKind::points) return nullptr;
  const PointField& field = *scene.points;
  const auto& index = static_cast<const WeightedPointIndex&>(*scene.field);
  auto points = std::make_shared<InputPoints>();
  points->soup = field.points;
  points->weights.assign(field.points->points.size(), -1);
  for (std::uint32_t site = 0; site < index.size(); ++site) {
    const std::size_t point = field.point.empty() ? site : field.point[site];
    points->weights[point] = static_cast<float>(std::sqrt(index.site(TriangleId(site)).weight) / scene.delta);
  }
  points->spacing = std::sqrt(index.area() / static_cast<double>(std::max<std::size_t>(index.size(), 1)));
  return points;
}

std::shared_ptr<const InputPoints> input_points(std::shared_ptr<const TriangleSoup> input) {
  if (!input->is_point_set()) return nullptr;
  auto points = std::make_shared<InputPoints>();
  points->weights.assign(input->points.size(), 0);
  const Vec3 extent = input->bounds().extent();
  const double area = 2 * (extent.x * extent.y + extent.y * extent.z + extent.z * extent.x);
  points->spacing = std::sqrt(area / static_cast<double>(points->size()));
  points->soup = std::move(input);
  return points;
}

glm::vec3 weight_color(ThemeKind theme, float weight) {
  const auto& stops = theme == ThemeKind::dark ? on_dark : on_light;
  const float at = std::clamp(weight, 0.0f, 1.0f) * (stops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const float t = at - static_cast<float>(i);
  return (1 - t) * rgb(stops[i]) + t * rgb(stops[i + 1]);
}

} // namespace isoscope
