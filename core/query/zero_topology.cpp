// Counting what a delta takes from Z and adds to it.
#include "query/zero_topology.h"

#include "base/sort_unique.h"
#include "mesh/junction.h"
#include "mesh/zero_set.h"

#include <algorithm>
#include <numeric>

namespace isoscope {
namespace {

/// Whether the whole of Z has to be counted anew after it.
bool changes_everything(const Delta& delta) {
  return delta.form || !delta.values.empty() || !delta.sides.empty() || !delta.dropped.empty();
}

} // namespace

ZeroTopology::Corner ZeroTopology::corner_of(std::array<VertexId, 4> around, std::size_t count) {
  // Invalid ids are the largest: what is not used stays behind.
  std::sort(around.begin(), around.end());
  const auto pack = [&](std::size_t i) {
    return i < count ? std::uint64_t{around[i].value} << 32 | around[std::min(i + 1, count - 1)].value : 0;
  };
  return {pack(0), pack(2)};
}

void ZeroTopology::add_junction(const Complex& complex, TetId t, std::vector<Polygon>& out) {
  const auto& v = complex.tet(t).v;
  const Junction junction = make_junction(complex.positions(t), complex.values(t), complex.labels(t), v);
  const auto corner = [&](std::uint8_t c) {
    if (c == Junction::center_corner) return corner_of(v, 4);
    if (c >= Junction::first_facet) {
      const auto f = complex.tet(t).facet(c - std::size_t{Junction::first_facet});
      return corner_of({f[0], f[1], f[2], {}}, 3);
    }
    const auto [i, j] = Junction::edge(c);
    return corner_of({v[i], v[j], {}, {}}, 2);
  };
  for (std::size_t k = 0; k < junction.count; ++k) {
    const auto& [a, b, c] = junction.facets[k].corner;
    out.push_back({{corner(a), corner(b), corner(c), {}}, 3});
  }
}

std::vector<ZeroTopology::Polygon> ZeroTopology::patch(const Complex& complex,
                                                       const std::vector<TetRecord>& tets,
                                                       const std::vector<FacetRecord>& facets) {
  std::vector<Polygon> found;
  const auto add_facet = [&](const std::array<VertexId, 3>& v) {
    Polygon p;
    p.count = 3;
    for (std::size_t i = 0; i < 3; ++i) p.corner[i] = corner_of({v[i], v[i], {}, {}}, 2);
    std::sort(p.corner.begin(), p.corner.begin() + 3);
    found.push_back(p);
  };
  switch (complex.form) {
  case ZeroForm::free:
    for (const FacetRecord& f : facets) add_facet(f.v);
    break;
  case ZeroForm::embedded:
    for (const TetRecord& t : tets)
      for (std::size_t i = 0; i < 4; ++i) {
        if (complex.on_zero_set(t.id, i)) add_facet(complex.tet(t.id).facet(i));
      }
    sort_unique(found); // a facet between two of them came from both
    break;
  case ZeroForm::interpolated:
    for (const TetRecord& t : tets) {
      const TetLabels labels = complex.labels(t.id);
      if (label_count(labels) > 2) {
        add_junction(complex, t.id, found);
        continue;
      }
      const ZeroPolygon polygon =
          zero_polygon(complex.positions(t.id), seen_from_front(complex.values(t.id), labels));
      if (polygon.count == 0) continue;
      Polygon p;
      p.count = static_cast<std::size_t>(polygon.count);
      const auto& v = complex.tet(t.id).v;
      for (std::size_t i = 0; i < p.count; ++i)
        p.corner[i] = corner_of({v[polygon.edge[i][0]], v[polygon.edge[i][1]], {}, {}}, 2);
      found.push_back(p);
    }
    break;
  }
  return found;
}

std::size_t ZeroTopology::pieces(const std::vector<Polygon>& polygons) {
  std::vector<std::pair<Corner, std::uint32_t>> corners;
  for (std::uint32_t i = 0; i < polygons.size(); ++i)
    for (std::size_t k = 0; k < polygons[i].count; ++k) corners.emplace_back(polygons[i].corner[k], i);
  std::sort(corners.begin(), corners.end());
  std::vector<std::uint32_t> parent(polygons.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto find = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  std::size_t pieces = polygons.size();
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (corners[i].first != corners[i - 1].first) continue;
    const std::uint32_t a = find(corners[i].second), b = find(corners[i - 1].second);
    if (a == b) continue;
    parent[a] = b;
    --pieces;
  }
  return pieces;
}

void ZeroTopology::change(const std::vector<Polygon>& polygons, int by) {
  // How many polygons there are at a corner or an edge then.
  const auto count = [by](auto& map, const auto& at, long& total) -> std::uint32_t {
    if (by > 0) {
      const std::uint32_t now = ++map[at];
      total += now == 1;
      return now;
    }
    const auto found = map.find(at);
    if (found == map.end()) return 0;
    const std::uint32_t now = --found->second;
    if (now > 0) return now;
    map.erase(found);
    --total;
    return 0;
  };
  for (const Polygon& p : polygons) {
    polygons_ += by;
    for (std::size_t i = 0; i < p.count; ++i) {
      const Corner a = p.corner[i], b = p.corner[(i + 1) % p.count];
      count(at_corner_, a, corners_);
      const std::uint32_t now = count(at_edge_, EdgeKey{std::min(a, b), std::max(a, b)}, edges_);
      const std::uint32_t was = by > 0 ? now - 1 : now + 1;
      border_edges_ += (now == 1) - (was == 1);
    }
  }
}

void ZeroTopology::count_components(const Complex& complex) {
  ++recounts_;
  const ZeroSet z = extract_zero_set(complex);
  components_ = z.components.size();
  loops_ = z.boundary_loops();
}

void ZeroTopology::count(const Complex& complex) {
  at_corner_.clear();
  at_edge_.clear();
  corners_ = edges_ = polygons_ = border_edges_ = 0;
  std::vector<TetRecord> tets;
  std::vector<FacetRecord> facets;
  for (std::size_t i = 0; i < complex.tets.size(); ++i)
    if (const Tet& t = complex.tets[i]; t.alive()) tets.push_back({TetId(i), t.v, t.side, t.dropped});
  for (std::size_t i = 0; i < complex.facets.size(); ++i)
    if (const ZeroFacet& f = complex.facets[i]; f.alive()) facets.push_back({FacetId(i), f.v});
  change(patch(complex, tets, facets), 1);
  count_components(complex);
}

void ZeroTopology::before(const Complex& complex, const Delta& delta) {
  if (changes_everything(delta)) return;
  const std::vector<Polygon> gone = patch(complex, delta.removed, delta.removed_facets);
  pieces_before_ = pieces(gone);
  border_edges_before_ = border_edges_;
  change(gone, -1);
}

void ZeroTopology::after(const Complex& complex, const Delta& delta) {
  if (changes_everything(delta)) return count(complex);
  const std::vector<Polygon> come = patch(complex, delta.added, delta.added_facets);
  const std::size_t pieces_after = pieces(come);
  change(come, 1);
  if (pieces_before_ > 1 || pieces_after > 1 || pieces_before_ != pieces_after ||
      border_edges_ != border_edges_before_)
    count_components(complex);
}

} // namespace isoscope
