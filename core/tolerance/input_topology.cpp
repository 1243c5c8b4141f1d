// Connectivity of the input after merging equal points, and its exact self-intersection test.
#include "base/disjoint_sets.h"
#include "base/place.h"
#include "tolerance/facet_turns.h"
#include "tolerance/self_intersections.h"
#include "tolerance/tolerance_volume.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace isoscope {
namespace {

std::size_t count_components(const WeldedMesh& mesh) {
  DisjointSets sets(mesh.points.size());
  std::size_t count = mesh.points.size();
  for (const auto& t : mesh.triangles) {
    if (sets.unite(t[0], t[1])) --count;
    if (sets.unite(t[0], t[2])) --count;
  }
  return count;
}

/// Whether every two neighbours run along their edge in opposite directions.
bool consistently_oriented(const std::vector<EdgeUse>& uses) {
  for (std::size_t i = 0; i + 1 < uses.size(); i += 2)
    if (uses[i].ascends == uses[i + 1].ascends) return false;
  return true;
}

/// Whether an oriented mesh meets itself, as far as the control lets it be found out.
bool self_intersects(const WeldedMesh& mesh, const RunControl& control) {
  const auto met = self_intersections(
      mesh.points, mesh.triangles, [&] { return control.cancelled(); }, 1);
  return !met || !met->empty();
}

/// What tells the sides of closed input, and what the user should know about that.
void choose_side_rule(const WeldedMesh& mesh, const std::vector<EdgeUse>& uses, SidesMode mode,
                      InputTopology& topology) {
  const bool embedded = topology.closed_manifold && topology.self_intersection_free;
  if (topology.closed_manifold && (mode == SidesMode::parity || (embedded && mode == SidesMode::automatic))) {
    topology.side_rule = SideRule::parity;
    return;
  }
  const FacetTurns turns = find_facet_turns(mesh, uses);
  const bool open = turns.closedness == Closedness::open;
  if (!open || mode != SidesMode::parity) topology.turns = turns.turns;
  topology.may_wind_open = open && mode != SidesMode::parity && !topology.every_region;
  if (open) return;
  const bool oriented = turns.closedness == Closedness::oriented;
  topology.side_rule = oriented && mode != SidesMode::parity ? SideRule::winding : SideRule::parity;
  if (!oriented && mode != SidesMode::parity)
    topology.notes.push_back("The input cannot be oriented near " + place(*turns.unoriented, place_digits) +
                             ": what lies between an odd number of its layers counts as inside.");
}

} // namespace

InputTopology analyse_input(const TriangleSoup& soup, SidesMode mode, const RunControl& control) {
  const WeldedMesh mesh = weld(soup);
  InputTopology topology;
  if (control.cancelled()) return topology;
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  if (control.cancelled()) return topology;
  topology.components = count_components(mesh);

  std::size_t edges = 0, border_edges = 0;
  bool crowded = false; // an edge of three triangles
  DisjointSets border(mesh.points.size());
  std::vector<std::uint8_t> on_border(mesh.points.size(), 0);
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end, ++edges) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    if (end - i == 2) continue;
    crowded = crowded || end - i > 2;
    ++border_edges;
    border.unite(uses[i].low, uses[i].high);
    on_border[uses[i].low] = on_border[uses[i].high] = 1;
    if (!topology.border && uses[i].low != uses[i].high)
      topology.border = 0.5 * (mesh.points[uses[i].low] + mesh.points[uses[i].high]);
  }
  if (control.cancelled()) return topology;
  const bool collapsed = std::any_of(mesh.triangles.begin(), mesh.triangles.end(), is_collapsed);
  topology.manifold = !collapsed && !crowded && !vertex_of_two_fans(mesh, uses);
  if (topology.manifold) {
    topology.euler_characteristic = static_cast<long>(mesh.points.size()) - static_cast<long>(edges) +
                                    static_cast<long>(mesh.triangles.size());
    std::size_t loops = 0;
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v) loops += on_border[v] != 0 && border.find(v) == v;
    topology.boundary_loops = loops;
  }
  if (topology.manifold && border_edges == 0) {
    topology.closed_manifold = true;
    topology.consistently_oriented = consistently_oriented(uses);
    std::vector<IndexTriangle> oriented = mesh.triangles;
    topology.self_intersection_free =
        !control.cancelled() && orient(oriented, uses) && !self_intersects(mesh, control);
  }
  if (control.cancelled()) return topology;
  topology.every_region = mode == SidesMode::multi;
  choose_side_rule(mesh, uses, topology.every_region ? SidesMode::automatic : mode, topology);
  return topology;
}

} // namespace isoscope
