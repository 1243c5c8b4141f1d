// Unions within a tile by facets, and between tiles by the vertices they have in common.
#include "tiles/tile_surface.h"

#include "base/disjoint_sets.h"
#include "base/point_order.h"
#include "run/mesh_connectivity.h"
#include "tolerance/self_intersections.h"

#include <algorithm>

namespace isoscope {
namespace {

using InTile = std::function<bool(Vec3)>;

/// The vertices in a tile, and the parts of what counts in it.
class Parts {
 public:
  Parts(const TriangleMesh& mesh, const InTile& in_tile)
      : mesh_(mesh), counted_(mesh.points.size()), seen_(mesh.points.size()), shared_(mesh.points.size()),
        part_(mesh.points.size(), no_part), sets_(mesh.points.size()) {
    for (std::size_t v = 0; v < counted_.size(); ++v)
      seen_[v] = counted_[v] = in_tile(mesh.points[v]) ? 1 : 0;
    for (const auto& t : mesh.triangles) {
      const bool own = counts(t);
      if (own) {
        sets_.unite(t[0], t[1]);
        sets_.unite(t[0], t[2]);
      }
      for (const std::uint32_t v : t) {
        if (own) seen_[v] = 1;
        if (!own || counted_[v] == 0) shared_[v] = 1;
      }
    }
    // The first of a set is its smallest, so that its part is there before others ask.
    for (std::uint32_t v = 0; v < part_.size(); ++v)
      if (seen_[v] != 0) part_[v] = sets_.find(v) == v ? count_++ : part_[sets_.find(v)];
  }

  bool counts(std::uint32_t v) const { return counted_[v] != 0; }
  bool counts(const std::array<std::uint32_t, 3>& t) const { return counts(std::min({t[0], t[1], t[2]})); }
  std::size_t part_of(const std::array<std::uint32_t, 3>& t) const {
    return counts(t) ? part_[t[0]] : no_part;
  }

  void fill(TileSurface& tile) const {
    tile.parts.resize(count_);
    for (std::uint32_t v = 0; v < part_.size(); ++v) {
      if (part_[v] == no_part) continue;
      SurfacePart& part = tile.parts[part_[v]];
      part.vertex = mesh_.points[v];
      if (counts(v)) {
        part.box.add(mesh_.points[v]);
        ++part.vertices;
        ++tile.vertices;
      }
      if (shared_[v] != 0) tile.links.push_back({mesh_.points[v], part_[v]});
    }
    for (const auto& t : mesh_.triangles) {
      if (!counts(t)) continue;
      ++tile.facets;
      tile.parts[part_[t[0]]].volume +=
          dot(mesh_.points[t[0]], cross(mesh_.points[t[1]], mesh_.points[t[2]]));
    }
  }

 private:
  const TriangleMesh& mesh_;
  std::vector<char> counted_, seen_,
      shared_;                    ///< by vertex: in the tile; in a part; in other tiles' facets too
  std::vector<std::size_t> part_; ///< by vertex
  DisjointSets sets_;
  std::size_t count_ = 0;
};

/// A pair counts in the tile of the lowest corner that both boxes have in common.
void find_intersections(const TriangleMesh& mesh, const InTile& in_tile, const std::function<bool()>& stop,
                        TileSurface& tile) {
  const auto pairs = self_intersections(mesh.points, mesh.triangles, stop);
  if (!pairs) return;
  const auto facet = [&](std::uint32_t f) {
    const auto& t = mesh.triangles[f];
    return Triangle3{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
  };
  for (const auto& [f, g] : *pairs) {
    const Vec3 a = box_of(facet(f)).lo, b = box_of(facet(g)).lo;
    if (!in_tile({std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)})) continue;
    if (tile.intersections++ == 0) tile.intersection = facet(f)[0];
  }
}

} // namespace

TileSurface judge_surface(const TriangleMesh& mesh, const InTile& in_tile,
                          const std::function<bool()>& stop) {
  TileSurface tile;
  if (mesh.triangles.empty()) return tile;
  const Parts parts(mesh, in_tile);
  parts.fill(tile);
  Certificate c;
  check_connectivity(mesh, false, c, [&](std::uint32_t v) { return parts.counts(v); });
  tile.closed_manifold = c.closed_manifold;
  tile.oriented = c.oriented;
  tile.failures = std::move(c.failures);
  tile.euler_characteristic = c.euler_characteristic;
  if (tile.closed_manifold && tile.oriented) find_intersections(mesh, in_tile, stop, tile);
  return tile;
}

std::vector<std::size_t> parts_of_facets(const TriangleMesh& mesh, const InTile& in_tile) {
  const Parts parts(mesh, in_tile);
  std::vector<std::size_t> of_facets;
  for (const auto& t : mesh.triangles) of_facets.push_back(parts.part_of(t));
  return of_facets;
}

std::size_t PartUnion::add(const TileSurface& tile) {
  const std::size_t first = parts_.size();
  parts_.insert(parts_.end(), tile.parts.begin(), tile.parts.end());
  for (const PartLink& link : tile.links) links_.push_back({link.vertex, first + link.part});
  return first;
}

void PartUnion::join() {
  std::sort(links_.begin(), links_.end(), [](const PartLink& a, const PartLink& b) {
    return a.vertex != b.vertex ? lies_before(a.vertex, b.vertex) : a.part < b.part;
  });
  DisjointSets sets(parts_.size());
  for (std::size_t i = 1; i < links_.size(); ++i)
    if (links_[i].vertex == links_[i - 1].vertex)
      sets.unite(static_cast<std::uint32_t>(links_[i].part), static_cast<std::uint32_t>(links_[i - 1].part));
  component_.resize(parts_.size());
  for (std::uint32_t i = 0; i < parts_.size(); ++i) {
    const std::uint32_t first = sets.find(i); // the smallest
    if (first == i) {
      component_[i] = components_.size();
      components_.push_back({{}, 0, 0, parts_[i].vertex});
    }
    component_[i] = component_[first];
    SurfacePart& component = components_[component_[i]];
    component.box.add(parts_[i].box);
    component.vertices += parts_[i].vertices;
    component.volume += parts_[i].volume;
  }
  links_.clear();
  parts_.clear();
}

} // namespace isoscope
