// Rays against boxes by slabs, against facets by Möller and Trumbore's test.
#include "scene/mosaic_scene.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

constexpr double brick_gap = 0.03; ///< around a brick, in its side

/// How far along the ray it enters the box; nothing where it does not.
std::optional<double> enters_box(const Box3& box, const Camera::Ray& ray) {
  double from = 0, to = Box3::inf;
  for (int a = 0; a < 3; ++a) {
    const double d = ray.direction[a];
    double low = (box.lo[a] - ray.origin[a]) / d, high = (box.hi[a] - ray.origin[a]) / d;
    if (d == 0) {
      if (ray.origin[a] < box.lo[a] || ray.origin[a] > box.hi[a]) return std::nullopt;
      continue;
    }
    if (low > high) std::swap(low, high);
    from = std::max(from, low);
    to = std::min(to, high);
  }
  return from <= to ? std::optional(from) : std::nullopt;
}

std::optional<double> meets_facet(const Triangle3& t, const Camera::Ray& ray) {
  const Vec3 u = t[1] - t[0], v = t[2] - t[0], across = cross(ray.direction, v);
  const double determinant = dot(u, across);
  if (determinant == 0) return std::nullopt;
  const Vec3 from = ray.origin - t[0], along = cross(from, u);
  const double a = dot(from, across) / determinant, b = dot(ray.direction, along) / determinant;
  const double at = dot(v, along) / determinant;
  if (a < 0 || b < 0 || a + b > 1 || at < 0) return std::nullopt;
  return at;
}

} // namespace

Box3 MosaicScene::bounds() const {
  Box3 box;
  for (const Tile& t : tiles)
    if (!t.box.empty()) box.add(t.box);
  return box;
}

glm::vec3 frozen_color(const SceneColors& colors) {
  return colors.selection;
}

Box3 drawn_box(const Box3& brick) {
  return brick.grown(-brick_gap * brick.longest_edge());
}

std::optional<MosaicPick> pick_mosaic(const MosaicScene& scene, const Camera::Ray& ray) {
  double nearest = Box3::inf;
  std::optional<std::uint32_t> tile;
  const auto take = [&](std::optional<double> at, std::uint32_t which) {
    if (!at || *at >= nearest) return;
    nearest = *at;
    tile = which;
  };
  for (const MosaicScene::Brick& b : scene.bricks)
    if (scene.tiles[b.tile].closed) take(enters_box(drawn_box(b.box), ray), b.tile);
  for (std::size_t f = 0; f < scene.facets.size(); ++f)
    if (const std::uint32_t t = scene.tile_of_facet[f]; !scene.tiles[t].closed)
      take(meets_facet(scene.facets[f], ray), t);
  if (!tile) return std::nullopt;
  return MosaicPick{*tile, ray.origin + nearest * ray.direction};
}

} // namespace isoscope
