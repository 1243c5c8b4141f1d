// Takes the shortest loop of each component that does not cut it in two.
#include "run/topology_places.h"

#include "base/disjoint_sets.h"
#include "base/geometry.h"
#include "base/place.h"
#include "mesh/shortest_loop.h"
#include "run/mesh_connectivity.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace isoscope {
namespace {

constexpr std::size_t most_named = 3;
/// Vertices through which loops are looked for: what is named need not be the very shortest.
constexpr std::size_t bases = 400;

/// The mesh as a zero set without a triangulation, its components by their first facet.
ZeroSet as_zero_set(const TriangleMesh& mesh) {
  constexpr std::uint32_t unnumbered = std::numeric_limits<std::uint32_t>::max();
  DisjointSets joined(mesh.points.size());
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 1; k < 3; ++k) joined.unite(t[0], t[k]);
  ZeroSet z;
  for (const Vec3& p : mesh.points) z.vertices.push_back({p, {}, {}});
  std::vector<std::uint32_t> number(mesh.points.size(), unnumbered);
  for (const auto& t : mesh.triangles) {
    std::uint32_t& component = number[joined.find(t[0])];
    if (component == unnumbered) {
      component = static_cast<std::uint32_t>(z.components.size());
      z.components.emplace_back();
    }
    ZeroSet::Polygon polygon;
    polygon.v = {t[0], t[1], t[2], 0};
    polygon.component = component;
    z.polygons.push_back(polygon);
    ++z.components[component].polygons;
  }
  return z;
}

struct Handle {
  double length = 0;
  Vec3 place;
};

/// The facets of a region's boundary.
TriangleMesh facets_around(const TriangleMesh& mesh, int label) {
  TriangleMesh boundary{mesh.points, {}};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.labels[t].front == label || mesh.labels[t].back == label)
      boundary.triangles.push_back(mesh.triangles[t]);
  return boundary;
}

std::vector<Handle> narrowest_handles(const ZeroSet& z, const RunControl& control) {
  std::vector<Handle> handles;
  for (std::uint32_t c = 0; c < z.components.size() && !control.out_of_grace(); ++c) {
    const auto loop = shortest_handle_loop(z, c, bases, control);
    if (!loop) continue;
    Vec3 sum;
    for (const std::uint32_t v : loop->vertices) sum = sum + z.vertices[v].position;
    handles.push_back({loop->length, sum / static_cast<double>(loop->vertices.size())});
  }
  std::stable_sort(handles.begin(), handles.end(),
                   [](const Handle& a, const Handle& b) { return a.length < b.length; });
  return handles;
}

Vec3 smallest_component(const ZeroSet& z) {
  std::vector<Box3> boxes(z.components.size());
  for (const ZeroSet::Polygon& p : z.polygons)
    for (std::uint8_t i = 0; i < p.count; ++i) boxes[p.component].add(z.vertices[p.v[i]].position);
  return std::min_element(boxes.begin(), boxes.end(),
                          [](const Box3& a, const Box3& b) { return a.longest_edge() < b.longest_edge(); })
      ->center();
}

} // namespace

std::string topology_places(const TriangleMesh& mesh, std::span<const RegionCertificate> regions,
                            const RunControl& control) {
  struct Place {
    Handle handle;
    int label;
  };
  std::vector<Place> places;
  for (const RegionCertificate& r : regions) {
    const bool handles = r.euler_characteristic < 2 * static_cast<long>(r.components);
    if (!r.closed_manifold || !handles) continue;
    for (const Handle& h : narrowest_handles(as_zero_set(facets_around(mesh, r.label)), control))
      places.push_back({h, r.label});
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.handle.length < b.handle.length; });
  std::string words;
  for (std::size_t i = 0; i < std::min(most_named, places.size()); ++i)
    words += (i == 0 ? "The boundary of " : ", of ") + name_of_region(places[i].label) +
             " has a handle near " + place(places[i].handle.place, place_digits);
  return words.empty() ? words : words + '.';
}

std::string topology_places(const TriangleMesh& mesh, const RunControl& control) {
  const ZeroSet z = as_zero_set(mesh);
  const std::vector<Handle> handles = narrowest_handles(z, control);
  std::string words;
  for (std::size_t i = 0; i < std::min(most_named, handles.size()); ++i)
    words += (i == 0 ? "The narrowest handles of its components are near " : ", ") +
             place(handles[i].place, place_digits);
  if (handles.size() == 1) words = "Its narrowest handle is near " + place(handles[0].place, place_digits);
  if (!words.empty()) words += ".";
  if (z.components.size() > 1)
    words += (words.empty() ? "The" : " The") + std::string(" smallest component is near ") +
             place(smallest_component(z), place_digits) + ".";
  return words;
}

} // namespace isoscope
