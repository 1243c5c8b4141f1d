// Sorted points, so that nothing depends on who wrote which facet first.
#include "tiles/tile_piece.h"

#include "base/point_order.h"
#include "tiles/facet_file.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>

namespace isoscope {
namespace {

/// Numbers points as they come; equal ones have one number.
class PointNumbers {
 public:
  /// A closed surface has about half as many points as facets.
  explicit PointNumbers(std::size_t facets) : slots_(std::bit_ceil(facets + 1), none) {
    points_.reserve(facets / 2 + 3);
  }

  std::uint32_t add(Vec3 p) {
    std::size_t at = slot_of(p);
    if (slots_[at] != none) return slots_[at];
    if (2 * (points_.size() + 1) > slots_.size()) {
      grow();
      at = slot_of(p);
    }
    slots_[at] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
    return slots_[at];
  }

  /// Once, in the end: all of them, ascending, and the place of each by its number.
  std::vector<std::uint32_t> sort(std::vector<Vec3>& ascending) {
    slots_ = {};
    std::vector<std::uint32_t> order(points_.size()), rank(points_.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return lies_before(points_[a], points_[b]); });
    ascending.reserve(order.size());
    for (const std::uint32_t i : order) {
      rank[i] = static_cast<std::uint32_t>(ascending.size());
      ascending.push_back(points_[i]);
    }
    return rank;
  }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// Where p is, or is to be.
  std::size_t slot_of(Vec3 p) const {
    std::uint64_t hash = 0;
    for (int a = 0; a < 3; ++a) { // both zeros are one
      hash = (hash ^ std::bit_cast<std::uint64_t>(p[a] + 0.0)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    std::size_t at = hash & (slots_.size() - 1);
    while (slots_[at] != none && points_[slots_[at]] != p) at = (at + 1) & (slots_.size() - 1);
    return at;
  }

  void grow() {
    slots_.assign(2 * slots_.size(), none);
    for (std::uint32_t i = 0; i < points_.size(); ++i) slots_[slot_of(points_[i])] = i;
  }

  std::vector<std::uint32_t> slots_; ///< a power of two of them, at most half of them taken
  std::vector<Vec3> points_;
};

} // namespace

TriangleMesh mesh_of(std::vector<Triangle3> facets) {
  make_canonical(facets);
  PointNumbers numbers(facets.size());
  TriangleMesh mesh;
  mesh.triangles.reserve(facets.size());
  for (const Triangle3& f : facets)
    mesh.triangles.push_back({numbers.add(f[0]), numbers.add(f[1]), numbers.add(f[2])});
  facets = {};
  const std::vector<std::uint32_t> rank = numbers.sort(mesh.points);
  for (auto& t : mesh.triangles)
    for (std::uint32_t& v : t) v = rank[v];
  return mesh;
}

TriangleSoup soup_of(std::vector<Triangle3> facets) {
  TriangleMesh mesh = mesh_of(std::move(facets));
  TriangleSoup soup;
  soup.points = std::move(mesh.points);
  soup.triangles = std::move(mesh.triangles);
  return soup;
}

ClosestPointIndex index_of(std::vector<Triangle3> facets, const RunControl& control) {
  make_canonical(facets);
  return {facets, control};
}

std::vector<Triangle3> facets_of(const TriangleMesh& mesh) {
  std::vector<Triangle3> facets;
  facets.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    facets.push_back({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
  return facets;
}

std::vector<Triangle3> facets_of(const TriangleSoup& soup) {
  std::vector<Triangle3> facets;
  facets.reserve(soup.triangles.size());
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) facets.push_back(soup.triangle(i));
  return facets;
}

void keep_meeting(std::vector<Triangle3>& facets, const Box3& box) {
  std::erase_if(facets, [&](const Triangle3& f) { return !box.meets(box_of(f)); });
}

void keep_own(std::vector<Triangle3>& facets, const TileGrid& grid, const Tiling& tiling,
              const GridPlace& tile) {
  std::erase_if(facets, [&](const Triangle3& f) {
    return grid.tile_of(tiling, grid.brick_of(canonical(f)[0])) != tile;
  });
}

std::vector<Vec3> kept_points(const TileManifest& manifest, const ChangeBox& box) {
  std::vector<Vec3> kept;
  for (const auto* points : {&manifest.witnesses, &manifest.held})
    for (const Vec3 p : *points)
      if (box.holds(p)) kept.push_back(p);
  return kept;
}

ImproverOptions tile_options(const CriteriaParameters& criteria, int effort) {
  ImproverOptions options = improver_options(criteria, effort);
  options.preserve_normals = false;
  options.thin = true;
  return options;
}

} // namespace isoscope
