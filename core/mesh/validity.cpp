// Checks by definition, without help from the code that maintains the structures.
#include "mesh/validity.h"

#include "base/sort_unique.h"
#include "mesh/predicates.h"

#include <algorithm>
#include <map>

namespace isoscope {

namespace {

using FacetKey = std::array<VertexId, 3>;

std::string name(TetId t) {
  return "tetrahedron " + std::to_string(t.value);
}

/// Whether the vertices exist and are in canonical order; what follows relies on it.
bool check_vertices(const Complex& complex, TetId t, std::vector<Defect>& defects) {
  auto v = complex.tet(t).v;
  for (const VertexId a : v) {
    if (!a.valid() || a.index() >= complex.vertices.size() || !complex.vertices[a.index()].alive) {
      defects.push_back({name(t) + " has a vertex that does not exist or is dead", t});
      return false;
    }
  }
  if (v[3] < v[2]) std::swap(v[2], v[3]);
  if (!(v[0] < v[1] && v[1] < v[2] && v[2] < v[3])) {
    defects.push_back({name(t) + " has its vertices out of order", t});
    return false;
  }
  return true;
}

void check_neighbors(const Complex& complex, TetId t, std::vector<Defect>& defects) {
  const Tet& tet = complex.tet(t);
  for (std::size_t i = 0; i < 4; ++i) {
    const TetId n = tet.neighbor[i];
    if (!n.valid()) continue;
    if (n.index() >= complex.tets.size() || !complex.tet(n).alive()) {
      defects.push_back({name(t) + " has a dead neighbour", t});
      continue;
    }
    const Tet& other = complex.tet(n);
    const auto back = std::find(other.neighbor.begin(), other.neighbor.end(), t);
    if (back == other.neighbor.end()) {
      defects.push_back({name(t) + " is not a neighbour of its neighbour " + name(n), t});
      continue;
    }
    const auto j = static_cast<std::size_t>(back - other.neighbor.begin());
    if ((tet.dropped >> i & 1) != (other.dropped >> j & 1)) {
      defects.push_back({name(t) + " and " + name(n) + " differ on whether their facet is dropped", t});
    }
    if (sorted(tet.facet(i)) != sorted(other.facet(j))) {
      defects.push_back({name(t) + " and its neighbour " + name(n) + " do not share that facet", t});
    }
  }
}

/// No facet with three sides, and none with two sides that do not know each other.
void check_facets(const Complex& complex, const std::vector<TetId>& alive, std::vector<Defect>& defects) {
  std::vector<std::pair<FacetKey, std::pair<TetId, bool>>> sides;
  for (const TetId t : alive) {
    for (std::size_t i = 0; i < 4; ++i) {
      sides.push_back({sorted(complex.tet(t).facet(i)), {t, complex.tet(t).neighbor[i].valid()}});
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i;
    while (j < sides.size() && sides[j].first == sides[i].first) ++j;
    const auto [t, has_neighbor] = sides[i].second;
    if (j - i > 2) defects.push_back({name(t) + " has a facet shared by more than two tetrahedra", t});
    if (j - i == 2 && (!has_neighbor || !sides[i + 1].second.second)) {
      defects.push_back({name(t) + " misses a neighbour across a shared facet", t});
    }
    if (j - i == 1 && has_neighbor)
      defects.push_back({name(t) + " has a neighbour across an unshared facet", t});
    i = j;
  }
}

/// The facets without neighbour form one closed, oriented, connected surface without handles.
void check_hull(const Complex& complex, const std::vector<TetId>& alive, std::vector<Defect>& defects) {
  std::map<std::pair<VertexId, VertexId>, int> halfedges;
  std::map<VertexId, VertexId> parent;
  const auto find = [&](VertexId v) {
    while (parent.at(v) != v) v = parent.at(v);
    return v;
  };
  long facets = 0;
  TetId somewhere;
  for (const TetId t : alive) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (complex.tet(t).neighbor[i].valid()) continue;
      ++facets;
      somewhere = t;
      const FacetKey f = complex.tet(t).facet(i);
      for (const VertexId v : f) parent.emplace(v, v);
      for (std::size_t k = 0; k < 3; ++k) {
        ++halfedges[{f[k], f[(k + 1) % 3]}];
        parent[find(f[k])] = find(f[(k + 1) % 3]);
      }
    }
  }
  if (alive.empty()) return;
  for (const auto& [edge, count] : halfedges) {
    const auto twin = halfedges.find({edge.second, edge.first});
    if (count != 1 || twin == halfedges.end()) {
      defects.push_back({"the hull is not closed and oriented at the edge " +
                             std::to_string(edge.first.value) + "–" + std::to_string(edge.second.value),
                         somewhere});
    }
  }
  const auto shells =
      std::count_if(parent.begin(), parent.end(), [](const auto& p) { return p.first == p.second; });
  const long chi = static_cast<long>(parent.size()) - static_cast<long>(halfedges.size() / 2) + facets;
  if (shells != 1) defects.push_back({"the hull has " + std::to_string(shells) + " shells", somewhere});
  if (shells == 1 && chi != 2) {
    defects.push_back({"the hull has Euler characteristic " + std::to_string(chi), somewhere});
  }
}

std::vector<TetId> alive_tets(const Complex& complex) {
  std::vector<TetId> alive;
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    if (complex.tets[i].alive()) alive.push_back(TetId(i));
  }
  return alive;
}

} // namespace

std::vector<Defect> check_complex(const Complex& complex) {
  std::vector<Defect> defects;
  const std::vector<TetId> alive = alive_tets(complex);
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    if (!complex.tets[i].alive() && complex.tets[i] != Tet{}) {
      defects.push_back({"dead " + name(TetId(i)) + " is not blank", TetId(i)});
    }
  }
  for (const TetId t : alive) check_vertices(complex, t, defects);
  if (!defects.empty()) return defects;
  for (const TetId t : alive) {
    const auto p = complex.positions(t);
    if (orientation(p[0], p[1], p[2], p[3]) <= 0) {
      defects.push_back({name(t) + " is flat or turned inside out", t});
    }
    check_neighbors(complex, t, defects);
  }
  check_facets(complex, alive, defects);
  check_hull(complex, alive, defects);
  return defects;
}

std::vector<Defect> check_delaunay(const Complex& complex) {
  std::vector<Defect> defects;
  for (const TetId t : alive_tets(complex)) {
    const Tet& tet = complex.tet(t);
    const auto p = complex.positions(t);
    for (const TetId n : tet.neighbor) {
      if (!n.valid()) continue;
      for (const VertexId v : complex.tet(n).v) {
        if (std::find(tet.v.begin(), tet.v.end(), v) == tet.v.end() &&
            side_of_sphere(p[0], p[1], p[2], p[3], complex.position(v)) > 0) {
          defects.push_back({"the circumball of " + name(t) + " holds vertex " + std::to_string(v.value), t});
        }
      }
    }
  }
  return defects;
}

std::vector<Defect> check_samples(const Complex& complex, const SampleSets& sets,
                                  std::span<const Vec3> positions) {
  std::vector<Defect> defects;
  std::vector<TetId> expected(positions.size());
  for (const TetId t : alive_tets(complex)) {
    const auto corners = complex.positions(t);
    Box3 box;
    for (const Vec3 c : corners) box.add(c);
    for (std::size_t s = 0; s < positions.size(); ++s) {
      const Vec3 x = positions[s];
      if (x.x < box.lo.x || x.x > box.hi.x || x.y < box.lo.y || x.y > box.hi.y || x.z < box.lo.z ||
          x.z > box.hi.z || !holds_perturbed(corners, x)) {
        continue;
      }
      if (expected[s].valid()) {
        defects.push_back({"sample " + std::to_string(s) + " lies in two tetrahedra", t});
      }
      expected[s] = t;
    }
  }
  for (std::size_t s = 0; s < positions.size(); ++s) {
    if (sets.tet_of(SampleId(s)) != expected[s]) {
      defects.push_back({"sample " + std::to_string(s) + " is not in " + name(expected[s]), expected[s]});
    }
  }
  std::size_t listed = 0;
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    SampleId last;
    sets.for_each(TetId(i), [&](SampleId s) {
      ++listed;
      if (sets.tet_of(s) != TetId(i) || (last.valid() && !(last < s))) {
        defects.push_back(
            {"the list of " + name(TetId(i)) + " is wrong at sample " + std::to_string(s.value), TetId(i)});
      }
      last = s;
    });
  }
  const auto held = static_cast<std::size_t>(
      std::count_if(expected.begin(), expected.end(), [](TetId t) { return t.valid(); }));
  if (listed != held) {
    defects.push_back({std::to_string(listed) + " samples are on lists, not " + std::to_string(held), {}});
  }
  return defects;
}

} // namespace isoscope
