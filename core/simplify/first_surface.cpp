// Judges, welds and orients the input.
#include "simplify/first_surface.h"

#include "base/disjoint_sets.h"
#include "base/place.h"
#include "tolerance/self_intersections.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <string>

namespace isoscope {
namespace {

Error no_start(const std::string& why) {
  return {ErrorCode::usage, "The input cannot be the first Z: " + why + ".", "Leave --start input out."};
}

/// Why a closed manifold is not known to be free of intersections.
Error crossing_error(const ToleranceVolume& volume) {
  WeldedMesh mesh = weld(volume.index());
  if (!orient(mesh.triangles, sorted_edge_uses(mesh.triangles)))
    return no_start("it cannot be oriented, so that it meets itself");
  const auto met = self_intersections(
      mesh.points, mesh.triangles, [] { return false; }, 1);
  if (!met || met->empty()) return no_start("whether it meets itself was not found out");
  const auto& [f, g] = met->front();
  const Vec3 p = mesh.points[mesh.triangles[f][0]];
  return no_start(f == g ? "a triangle at " + place(p, place_digits) + " has no area"
                         : "it meets itself, in a triangle at " + place(p, place_digits));
}

Error manifold_error(const ToleranceVolume& volume) {
  const WeldedMesh mesh = weld(volume.index());
  const auto collapsed = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), is_collapsed);
  if (collapsed != mesh.triangles.end())
    return no_start("a triangle at " + place(mesh.points[(*collapsed)[0]], place_digits) +
                    " has a vertex twice");
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    if (end - i == 2) continue;
    const Vec3 middle = 0.5 * (mesh.points[uses[i].low] + mesh.points[uses[i].high]);
    return no_start(end - i == 1 ? "it is open, it has a border at " + place(middle, place_digits)
                                 : "the edge at " + place(middle, place_digits) + " has " +
                                       std::to_string(end - i) + " triangles");
  }
  if (const auto v = vertex_of_two_fans(mesh, uses))
    return no_start("parts of it touch in the vertex at " + place(mesh.points[*v], place_digits));
  return no_start("it is no closed manifold");
}

} // namespace

Status can_start_from_input(const ToleranceVolume& volume) {
  if (!volume.has_surface())
    return no_start(volume.field().kind() == FieldKind::points ? "it is points, no surface"
                                                               : "it gives a volume, no surface inside it");
  if (!volume.input().closed_manifold) return manifold_error(volume);
  if (!volume.input().self_intersection_free) return crossing_error(volume);
  if (volume.has_rooms()) return no_start("it bounds several insides, which the improver does not know");
  if (volume.has_inner_walls()) return no_start("some of its walls have inside on both sides");
  return {};
}

TriangleMesh surface_of_input(const ToleranceVolume& volume) {
  const ClosestPointIndex& index = volume.index();
  WeldedMesh mesh = weld(index);
  const std::vector<IndexTriangle> given = mesh.triangles;
  orient(mesh.triangles, sorted_edge_uses(mesh.triangles));
  DisjointSets components(mesh.points.size());
  for (const auto& t : mesh.triangles) {
    components.unite(t[0], t[1]);
    components.unite(t[0], t[2]);
  }
  std::vector<double> volumes(mesh.points.size(), 0); // by the first vertex of a component, times 6
  std::vector<std::vector<std::uint32_t>> triangles(mesh.points.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const std::uint32_t first = components.find(v[0]);
    const Vec3 o = mesh.points[first];
    volumes[first] += dot(mesh.points[v[0]] - o, cross(mesh.points[v[1]] - o, mesh.points[v[2]] - o));
    triangles[first].push_back(t);
  }
  const auto turn = [&](std::uint32_t t) { std::swap(mesh.triangles[t][1], mesh.triangles[t][2]); };
  std::vector<std::int8_t> turns(mesh.triangles.size());
  std::vector<std::uint32_t> firsts;
  for (std::uint32_t first = 0; first < triangles.size(); ++first) {
    if (triangles[first].empty()) continue;
    firsts.push_back(first);
    for (const std::uint32_t t : triangles[first]) {
      if (volumes[first] < 0) turn(t);
      const auto& v = mesh.triangles[t];
      const auto at = std::find(given[t].begin(), given[t].end(), v[0]) - given[t].begin();
      turns[t] = given[t][static_cast<std::size_t>(at + 1) % 3] == v[1] ? 1 : -1;
    }
  }
  if (firsts.size() == 1) return {mesh.points, mesh.triangles};
  // A component in an odd number of others bounds a cavity.
  const std::vector<std::int8_t> all_turns = turns;
  for (const std::uint32_t first : firsts) {
    for (const std::uint32_t t : triangles[first]) turns[t] = 0;
    const int around = index.winding_number(mesh.points[first], turns);
    for (const std::uint32_t t : triangles[first]) {
      turns[t] = all_turns[t];
      if (around % 2 != 0) turn(t);
    }
  }
  return {mesh.points, mesh.triangles};
}

} // namespace isoscope
