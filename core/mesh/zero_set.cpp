// Extracts Z and ∂Γ; numbering follows sorted edges of T, so that it depends on T alone.
#include "mesh/zero_set.h"

#include "base/disjoint_sets.h"
#include "base/sort_unique.h"
#include "mesh/junction.h"

#include <algorithm>
#include <map>

namespace isoscope {

namespace {

/// Even permutations (i, j, k, l) for each pair i < j.
constexpr std::array<std::array<std::uint8_t, 4>, 6> even_pairs{
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

using LocalEdge = std::array<std::uint8_t, 2>;

/// Local edges of the zero polygon in order; returns how many.
int polygon_edges(const std::array<double, 4>& f, std::array<LocalEdge, 4>& edge) {
  unsigned negative = 0, count = 0;
  for (unsigned i = 0; i < 4; ++i) {
    if (f[i] == 0) return 0;
    if (f[i] < 0) {
      negative |= 1u << i;
      ++count;
    }
  }
  if (count == 0 || count == 4) return 0;
  if (count == 2) {
    for (const auto& [i, j, k, l] : even_pairs) {
      if (negative == ((1u << i) | (1u << j))) {
        edge = {LocalEdge{i, k}, LocalEdge{i, l}, LocalEdge{j, l}, LocalEdge{j, k}};
        return 4;
      }
    }
  }
  const unsigned lone_mask = count == 1 ? negative : ~negative & 15u;
  std::uint8_t lone = 0;
  while (lone_mask != (1u << lone)) ++lone;
  const auto& o = outward_facets[lone];
  if (count == 1) {
    edge = {LocalEdge{lone, o[0]}, LocalEdge{lone, o[1]}, LocalEdge{lone, o[2]}, LocalEdge{}};
  } else {
    edge = {LocalEdge{o[2], lone}, LocalEdge{o[1], lone}, LocalEdge{o[0], lone}, LocalEdge{}};
  }
  return 3;
}

std::uint64_t pack(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{a} << 32 | b;
}

/// Numbers the components in the order of the polygons and counts their parts.
void find_components(ZeroSet& z) {
  DisjointSets sets(z.vertices.size());
  std::vector<std::uint64_t> edges;
  edges.reserve(4 * z.polygons.size());
  for (const auto& p : z.polygons) {
    for (std::size_t i = 0; i < p.count; ++i) {
      const std::uint32_t a = p.v[i], b = p.v[(i + 1) % p.count];
      edges.push_back(pack(std::min(a, b), std::max(a, b)));
      sets.unite(a, b);
    }
  }
  std::sort(edges.begin(), edges.end());
  // A border is where an edge has one polygon; its curves are counted by their smallest vertices.
  DisjointSets border(z.vertices.size());
  std::vector<std::uint32_t> on_border;
  std::size_t distinct = 0;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    if (end - i == 1) {
      const auto a = static_cast<std::uint32_t>(edges[i] >> 32), b = static_cast<std::uint32_t>(edges[i]);
      border.unite(a, b);
      on_border.push_back(a);
      on_border.push_back(b);
    }
    edges[distinct++] = edges[i];
  }
  edges.resize(distinct);
  sort_unique(on_border);

  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> number(z.vertices.size(), none);
  for (auto& p : z.polygons) {
    std::uint32_t& n = number[sets.find(p.v[0])];
    if (n == none) {
      n = static_cast<std::uint32_t>(z.components.size());
      z.components.emplace_back();
    }
    p.component = n;
    ++z.components[n].polygons;
  }
  for (std::uint32_t v = 0; v < z.vertices.size(); ++v) ++z.components[number[sets.find(v)]].vertices;
  for (const std::uint64_t e : edges) {
    ++z.components[number[sets.find(static_cast<std::uint32_t>(e >> 32))]].edges;
  }
  for (const std::uint32_t v : on_border) {
    if (border.find(v) == v) ++z.components[number[sets.find(v)]].loops;
  }
}

/// Corners of Z in T while they are collected: an edge's two ends, or `no_vertex` and the number of a
/// junction.
constexpr std::uint32_t no_vertex = 0xffffffffu;
using CornerKey = std::uint64_t;

/// The junctions of T, numbered as they are met.
class Junctions {
 public:
  explicit Junctions(const Complex& complex) : complex_(complex) {}

  /// Appends the polygons of a tetrahedron of three labels or more.
  void add(TetId t, std::vector<ZeroSet::Polygon>& polygons, std::vector<std::array<CornerKey, 4>>& corners) {
    const Tet& tet = complex_.tet(t);
    const TetLabels labels = complex_.labels(t);
    const Junction junction = make_junction(complex_.positions(t), complex_.values(t), labels, tet.v);
    const std::uint32_t center = next(junction.center(), {tet.v[0], tet.v[1], tet.v[2], tet.v[3]});
    const auto key = [&](std::uint8_t corner) {
      if (corner == Junction::center_corner) return pack(no_vertex, center);
      if (corner >= Junction::first_facet) return pack(no_vertex, facet(tet, corner, junction));
      const auto [i, j] = Junction::edge(corner);
      return labels[i] < labels[j] ? pack(tet.v[i].value, tet.v[j].value)
                                   : pack(tet.v[j].value, tet.v[i].value);
    };
    for (std::size_t k = 0; k < junction.count; ++k) {
      const Junction::Facet& f = junction.facets[k];
      polygons.push_back({t, {}, 3, 0, {}, f.labels});
      corners.push_back({key(f.corner[0]), key(f.corner[1]), key(f.corner[2]), 0});
    }
  }
  const std::vector<ZeroSet::ZeroVertex>& vertices() const { return vertices_; }

 private:
  std::uint32_t facet(const Tet& tet, std::uint8_t corner, const Junction& junction) {
    std::array<VertexId, 3> v = tet.facet(corner - std::size_t{Junction::first_facet});
    std::sort(v.begin(), v.end());
    const auto [at, fresh] = facets_.emplace(v, static_cast<std::uint32_t>(vertices_.size()));
    if (fresh) next(junction.position[corner], {v[0], v[1], v[2]});
    return at->second;
  }
  std::uint32_t next(Vec3 position, std::initializer_list<VertexId> around) {
    const auto by_label = [this](VertexId a, VertexId b) { return complex_.label(a) < complex_.label(b); };
    const auto [lowest, highest] = std::minmax_element(around.begin(), around.end(), by_label);
    vertices_.push_back({position, *lowest, *highest, true});
    return static_cast<std::uint32_t>(vertices_.size() - 1);
  }

  const Complex& complex_;
  std::map<std::array<VertexId, 3>, std::uint32_t> facets_;
  std::vector<ZeroSet::ZeroVertex> vertices_;
};

ZeroSet interpolated_zero_set(const Complex& complex) {
  ZeroSet z;
  std::vector<CornerKey> keys;
  std::vector<std::array<CornerKey, 4>> corner_keys;
  Junctions junctions(complex);
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    const TetId t(i);
    if (!complex.tet(t).alive()) continue;
    const TetLabels labels = complex.labels(t);
    const int label_number = label_count(labels);
    if (label_number < 2) continue;
    const std::size_t first = z.polygons.size();
    if (label_number > 2) {
      junctions.add(t, z.polygons, corner_keys);
    } else {
      const LabelPair pair = outer_labels(labels);
      std::array<LocalEdge, 4> edge{};
      const int count = polygon_edges(seen_from(pair.front, complex.values(t), labels), edge);
      if (count == 0) continue;
      const auto& v = complex.tet(t).v;
      z.polygons.push_back({t, {}, static_cast<std::uint8_t>(count), 0, {}, pair});
      auto& corners = corner_keys.emplace_back();
      for (std::size_t k = 0; k < z.polygons.back().count; ++k)
        corners[k] = pack(v[edge[k][0]].value, v[edge[k][1]].value);
    }
    for (std::size_t p = first; p < z.polygons.size(); ++p)
      for (std::size_t k = 0; k < z.polygons[p].count; ++k)
        if (corner_keys[p][k] >> 32 != no_vertex) keys.push_back(corner_keys[p][k]);
  }
  sort_unique(keys);
  z.vertices.reserve(keys.size() + junctions.vertices().size());
  for (const CornerKey key : keys) {
    const VertexId n(static_cast<std::uint32_t>(key >> 32)), p(static_cast<std::uint32_t>(key));
    z.vertices.push_back({zero_point(complex.position(n), -std::abs(complex.value(n)), complex.position(p),
                                     std::abs(complex.value(p))),
                          n, p});
  }
  z.vertices.insert(z.vertices.end(), junctions.vertices().begin(), junctions.vertices().end());
  const auto number = [&](CornerKey key) {
    if (key >> 32 == no_vertex) return static_cast<std::uint32_t>(keys.size() + (key & no_vertex));
    const auto at = std::lower_bound(keys.begin(), keys.end(), key);
    return static_cast<std::uint32_t>(at - keys.begin());
  };
  for (std::size_t i = 0; i < z.polygons.size(); ++i)
    for (std::size_t k = 0; k < z.polygons[i].count; ++k) z.polygons[i].v[k] = number(corner_keys[i][k]);
  find_components(z);
  return z;
}

/// Z from facets whose corners are vertices of the state; `polygons` come with ids of those in `v`.
ZeroSet number_vertices(const Complex& complex, std::vector<ZeroSet::Polygon> polygons) {
  ZeroSet z;
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> number(complex.vertices.size(), none);
  for (const auto& p : polygons) {
    for (std::size_t k = 0; k < p.count; ++k) number[p.v[k]] = 0;
  }
  for (std::uint32_t v = 0; v < number.size(); ++v) {
    if (number[v] == none) continue;
    number[v] = static_cast<std::uint32_t>(z.vertices.size());
    z.vertices.push_back({complex.vertices[v].position, VertexId(v), VertexId(v)});
  }
  for (auto& p : polygons) {
    for (std::size_t k = 0; k < p.count; ++k) p.v[k] = number[p.v[k]];
  }
  z.polygons = std::move(polygons);
  find_components(z);
  return z;
}

ZeroSet embedded_zero_set(const Complex& complex) {
  std::vector<ZeroSet::Polygon> polygons;
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    const Tet& tet = complex.tets[i];
    if (!tet.alive()) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!complex.on_zero_set(TetId(i), k)) continue;
      const std::int8_t back = complex.tet(tet.neighbor[k]).side;
      if (back > tet.side) continue;
      // Outward of the tetrahedron of the larger label is the side of the smaller one: turned round.
      const auto [a, b, c] = tet.facet(k);
      polygons.push_back({TetId(i), {a.value, c.value, b.value, 0}, 3, 0, {}, {tet.side, back}});
    }
  }
  return number_vertices(complex, std::move(polygons));
}

ZeroSet free_zero_set(const Complex& complex) {
  std::vector<ZeroSet::Polygon> polygons;
  for (std::size_t i = 0; i < complex.facets.size(); ++i) {
    if (!complex.facets[i].alive()) continue;
    const auto& [a, b, c] = complex.facets[i].v;
    polygons.push_back(
        {TetId(), {a.value, b.value, c.value, 0}, 3, 0, FacetId(i), complex.labels(FacetId(i))});
  }
  return number_vertices(complex, std::move(polygons));
}

} // namespace

long ZeroSet::euler_characteristic() const {
  long sum = 0;
  for (const Component& c : components) sum += c.euler_characteristic();
  return sum;
}

std::size_t ZeroSet::boundary_loops() const {
  std::size_t sum = 0;
  for (const Component& c : components) sum += c.loops;
  return sum;
}

bool ZeroSet::has_rooms() const {
  return std::any_of(polygons.begin(), polygons.end(), [](const Polygon& p) {
    return p.labels != LabelPair{+1, -1};
  });
}

ZeroPolygon zero_polygon(const std::array<Vec3, 4>& p, const std::array<double, 4>& f) {
  ZeroPolygon polygon;
  polygon.count = polygon_edges(f, polygon.edge);
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i) {
    const auto [n, q] = polygon.edge[i];
    polygon.corner[i] = zero_point(p[n], f[n], p[q], f[q]);
  }
  return polygon;
}

PolygonSplit split_polygon(const std::array<Vec3, 4>& corner, int count) {
  if (count == 0) return {};
  if (count == 3) return {{{{0, 1, 2}}}, 1};
  if (squared_length(corner[2] - corner[0]) <= squared_length(corner[3] - corner[1]))
    return {{{{0, 1, 2}, {0, 2, 3}}}, 2};
  return {{{{0, 1, 3}, {1, 2, 3}}}, 2};
}

ZeroSet extract_zero_set(const Complex& complex) {
  switch (complex.form) {
  case ZeroForm::interpolated:
    return interpolated_zero_set(complex);
  case ZeroForm::embedded:
    return embedded_zero_set(complex);
  case ZeroForm::free:
    break;
  }
  return free_zero_set(complex);
}

TriangleMesh triangulate(const ZeroSet& zero_set) {
  TriangleMesh mesh;
  const bool rooms = zero_set.has_rooms();
  mesh.points.reserve(zero_set.vertices.size());
  for (const auto& v : zero_set.vertices) mesh.points.push_back(v.position);
  for (const auto& p : zero_set.polygons) {
    std::array<Vec3, 4> corner{};
    for (std::size_t k = 0; k < p.count; ++k) corner[k] = mesh.points[p.v[k]];
    const PolygonSplit split = split_polygon(corner, p.count);
    for (std::size_t k = 0; k < split.count; ++k) {
      const auto [i, j, l] = split.triangles[k];
      mesh.triangles.push_back({p.v[i], p.v[j], p.v[l]});
      if (rooms) mesh.labels.push_back(p.labels);
    }
  }
  return mesh;
}

std::vector<GammaFacet> gamma_boundary(const Complex& complex) {
  std::vector<GammaFacet> facets;
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    const TetId t(i);
    const Tet& tet = complex.tet(t);
    if (!tet.alive() || !complex.in_gamma(t)) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const TetId n = tet.neighbor[k];
      if (n.valid() && complex.in_gamma(n)) continue;
      facets.push_back({t, tet.facet(k)});
    }
  }
  return facets;
}

} // namespace isoscope
