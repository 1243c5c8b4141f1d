// Sorted points, so that nothing depends on who wrote which facet first.
#include "tiles/tile_piece.h"

#include "base/point_order.h"
#include "input/point_numbers.h"
#include "tiles/facet_file.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace isoscope {
namespace {

/// Sorts the points and returns the new place of each.
std::vector<std::uint32_t> sort_points(std::vector<Vec3>& points) {
  std::vector<std::uint32_t> order(points.size()), rank(points.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return lies_before(points[a], points[b]); });
  std::vector<Vec3> ascending;
  ascending.reserve(order.size());
  for (const std::uint32_t i : order) {
    rank[i] = static_cast<std::uint32_t>(ascending.size());
    ascending.push_back(points[i]);
  }
  points = std::move(ascending);
  return rank;
}

} // namespace

TriangleMesh mesh_of(std::vector<Triangle3> facets) {
  make_canonical(facets);
  TriangleMesh mesh;
  mesh.triangles.reserve(facets.size());
  {
    // A closed surface has about half as many points as facets.
    PointNumbers numbers(mesh.points, facets.size() / 2 + 3);
    for (const Triangle3& f : facets)
      mesh.triangles.push_back({numbers.number(f[0]), numbers.number(f[1]), numbers.number(f[2])});
  }
  facets = {};
  const std::vector<std::uint32_t> rank = sort_points(mesh.points);
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

/// A tile is one of many and has to end, whatever the effort.
constexpr std::size_t most_tile_rounds = 40;

ImproverOptions tile_options(const CriteriaParameters& criteria, int effort) {
  ImproverOptions options = improver_options(criteria, effort);
  options.preserve_normals = false;
  options.thin = true;
  options.most_rounds = most_tile_rounds;
  return options;
}

} // namespace isoscope
