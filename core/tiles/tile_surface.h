// What a tile's part of a surface is as a surface, so that the tiles' parts add up to all of it.
#pragma once

#include "input/triangle_soup.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace isoscope {

/// A connected part of what a tile has of a surface.
struct SurfacePart {
  Box3 box; ///< of its vertices in the tile
  std::size_t vertices = 0;
  double volume = 0; ///< that its facets enclose with the origin, times 6; outward ones count positive
  Vec3 vertex;       ///< one of it
};
/// A vertex by which a part goes on in another tile, that has the same.
struct PartLink {
  Vec3 vertex;
  std::size_t part = 0;
};

/// Each vertex, with the edges and facets of which it is the lowest, and each pair of facets count in one
/// tile.
struct TileSurface {
  bool closed_manifold = true, oriented = true;
  std::vector<std::string> failures; ///< of those
  long euler_characteristic = 0;
  std::uint64_t vertices = 0, facets = 0;
  std::vector<SurfacePart> parts;
  std::vector<PartLink> links;
  std::size_t intersections =
      0;             ///< pairs of facets; not looked for where closed_manifold or oriented is false
  Vec3 intersection; ///< the lowest vertex of one of them
};

/// `mesh`: all facets whose boxes meet the tile, as mesh_of() has them. Of no use once stop() is true.
TileSurface judge_surface(const TriangleMesh& mesh, const std::function<bool(Vec3)>& in_tile,
                          const std::function<bool()>& stop);

/// The part that a facet is in; none for those that count in other tiles.
constexpr std::size_t no_part = ~std::size_t{0};
std::vector<std::size_t> parts_of_facets(const TriangleMesh& mesh, const std::function<bool(Vec3)>& in_tile);

/// Joins the parts of all tiles to components.
class PartUnion {
 public:
  /// The number that the tile's first part gets; the others follow.
  std::size_t add(const TileSurface& tile);
  /// Once, after all of them.
  void join();
  const std::vector<SurfacePart>& components() const { return components_; }
  std::size_t component_of(std::size_t part) const { return component_[part]; }

 private:
  std::vector<SurfacePart> parts_, components_;
  std::vector<PartLink> links_;
  std::vector<std::size_t> component_; ///< by part
};

} // namespace isoscope
