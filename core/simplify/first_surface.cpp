// Judges, welds and orients the input; tries lattices until one has the topology.
#include "simplify/first_surface.h"

#include "base/disjoint_sets.h"
#include "base/numbers.h"
#include "base/place.h"
#include "simplify/lattice_surface.h"
#include "tolerance/self_intersections.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <string>

namespace isoscope {
namespace {

Error no_start(const std::string& why) {
  return {ErrorCode::usage, "The input cannot be the first Z: " + why + ".",
          "Leave --start input out, or take --start lattice."};
}

/// Why a closed manifold is not known to be free of intersections.
Error crossing_error(const ClosestPointIndex& index) {
  WeldedMesh mesh = weld(index);
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

Error manifold_error(const ClosestPointIndex& index) {
  const WeldedMesh mesh = weld(index);
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

FirstSurface itself(const WeldedMesh& mesh) {
  FirstSurface first;
  first.mesh = {mesh.points, mesh.triangles};
  first.words = "the input itself";
  return first;
}

/// Of a closed mesh.
FirstSurface::Look look_at(const TriangleMesh& mesh) {
  const std::size_t n = mesh.points.size(), edges = mesh.triangles.size() * 3 / 2;
  DisjointSets pieces(n);
  std::size_t components = n;
  for (const auto& t : mesh.triangles) {
    if (pieces.unite(t[0], t[1])) --components;
    if (pieces.unite(t[0], t[2])) --components;
  }
  return {static_cast<long>(n) - static_cast<long>(edges) + static_cast<long>(mesh.triangles.size()),
          components};
}

/// What a facet of the first Z takes while it is improved.
constexpr double bytes_of_facet = 500;
constexpr int finest_share = 4; ///< of the coarsest lattice's edge

} // namespace

Status can_start_from_input(const ToleranceField& field, const InputTopology& topology) {
  const ClosestPointIndex* index = field.surface();
  if (index == nullptr)
    return no_start(field.kind() == FieldKind::points ? "it is points, no surface"
                                                      : "it gives a volume, no surface inside it");
  if (!topology.closed_manifold) return manifold_error(*index);
  if (!topology.self_intersection_free) return crossing_error(*index);
  return {};
}

Status can_start_from_input(const ToleranceVolume& volume) {
  if (Status can = can_start_from_input(volume.field(), volume.input()); !can) return can;
  if (volume.has_rooms()) return no_start("it bounds several insides, which the improver does not know");
  if (volume.has_inner_walls()) return no_start("some of its walls have inside on both sides");
  return {};
}

FirstSurface first_from_input(const ToleranceVolume& volume) {
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
  if (firsts.size() == 1) return itself(mesh);
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
  return itself(mesh);
}

Status can_start_from_lattice(const ToleranceVolume& volume) {
  if (volume.sides().known() && volume.open_sides() == nullptr) return {};
  return Error{ErrorCode::usage,
               "--start lattice asks on which side of the input each point is, and of this one only regions "
               "have sides.",
               "Leave --start lattice out."};
}

Result<FirstSurface> first_from_lattice(const ToleranceVolume& volume, const ExpectedTopology& expected,
                                        double most_bytes, const RunControl& control) {
  const auto most_facets = static_cast<std::size_t>(std::min(most_bytes / bytes_of_facet, 4e9));
  FirstSurface first;
  for (int share = 1; share <= finest_share; ++share) {
    auto made = lattice_surface(volume, coarsest_lattice / share, most_facets, control);
    if (!made && (control.cancelled() || first.looks.empty())) return made.error();
    if (!made) {
      first.warning += " " + made.error().message;
      return first;
    }
    first.mesh = std::move(made->mesh);
    first.words = "from a lattice of h = " + general(made->edge / volume.thresholds().delta, 3) + " δ";
    const FirstSurface::Look look = first.looks.emplace_back(look_at(first.mesh));
    if (look.components > 0 &&
        expected.euler_characteristic.value_or(look.euler_characteristic) == look.euler_characteristic &&
        expected.components.value_or(look.components) == look.components) {
      first.warning.clear();
      return first;
    }
    first.warning = "The first Z has χ = " + std::to_string(look.euler_characteristic) + " in " +
                    std::to_string(look.components) + (look.components == 1 ? " component" : " components") +
                    ", not what is expected, and the improver changes neither.";
  }
  return first;
}

} // namespace isoscope
