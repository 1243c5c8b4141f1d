// Edges of Z by the number of their polygons, and vertices by the number of such edges.
#include "mesh/zero_curves.h"

#include <algorithm>

namespace isoscope {

namespace {

struct PolygonEdge {
  ZeroCurves::Edge sorted, as_it_runs;
};

bool less(const PolygonEdge& a, const PolygonEdge& b) {
  return a.sorted < b.sorted;
}

} // namespace

ZeroCurves zero_curves(const ZeroSet& zero_set) {
  if (zero_set.boundary_loops() == 0 && !zero_set.has_rooms()) return {};
  std::vector<PolygonEdge> uses;
  uses.reserve(3 * zero_set.polygons.size());
  for (const ZeroSet::Polygon& p : zero_set.polygons)
    for (std::size_t k = 0; k < p.count; ++k) {
      const ZeroCurves::Edge edge{p.v[k], p.v[(k + 1) % p.count]};
      uses.push_back({{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}, edge});
    }
  std::sort(uses.begin(), uses.end(), less);

  ZeroCurves curves;
  std::vector<std::uint32_t> ends;
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].sorted == uses[i].sorted) ++end;
    if (end - i == 2) continue;
    if (end - i == 1)
      curves.border.push_back(uses[i].as_it_runs);
    else
      curves.triple.push_back(uses[i].sorted);
    ends.insert(ends.end(), uses[i].sorted.begin(), uses[i].sorted.end());
  }
  std::sort(curves.border.begin(), curves.border.end());
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0, end = 0; i < ends.size(); i = end) {
    while (end < ends.size() && ends[end] == ends[i]) ++end;
    if (end - i != 2) curves.points.push_back(ends[i]);
  }
  return curves;
}

std::vector<DroppedFacet> dropped_facets(const Complex& complex) {
  std::vector<DroppedFacet> facets;
  if (complex.form != ZeroForm::embedded) return facets;
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    const Tet& tet = complex.tets[i];
    if (!tet.alive() || tet.dropped == 0) continue;
    for (std::uint8_t k = 0; k < 4; ++k)
      if ((tet.dropped >> k & 1u) != 0 && complex.tet(tet.neighbor[k]).side < tet.side)
        facets.push_back({TetId(i), k});
  }
  return facets;
}

} // namespace isoscope
