// Sorted points, so that nothing depends on who wrote which facet first.
#include "tiles/tile_piece.h"

#include "base/point_order.h"
#include "tiles/facet_file.h"

#include <algorithm>

namespace isoscope {

TriangleMesh mesh_of(std::vector<Triangle3> facets) {
  make_canonical(facets);
  TriangleMesh mesh;
  for (const Triangle3& f : facets) mesh.points.insert(mesh.points.end(), f.begin(), f.end());
  std::sort(mesh.points.begin(), mesh.points.end(), lies_before);
  mesh.points.erase(std::unique(mesh.points.begin(), mesh.points.end()), mesh.points.end());
  const auto vertex = [&](Vec3 p) {
    return static_cast<std::uint32_t>(
        std::lower_bound(mesh.points.begin(), mesh.points.end(), p, lies_before) - mesh.points.begin());
  };
  for (const Triangle3& f : facets) mesh.triangles.push_back({vertex(f[0]), vertex(f[1]), vertex(f[2])});
  return mesh;
}

TriangleSoup soup_of(std::vector<Triangle3> facets) {
  TriangleMesh mesh = mesh_of(std::move(facets));
  TriangleSoup soup;
  soup.points = std::move(mesh.points);
  soup.triangles = std::move(mesh.triangles);
  return soup;
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
