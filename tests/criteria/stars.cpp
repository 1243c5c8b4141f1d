// Bipyramids about an edge; stars by brute force.
#include "criteria/stars.h"

#include "mesh/predicates.h"
#include "mesh/support.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace isoscope::test {

EdgeStar make_star(const std::vector<Vec3>& positions,
                   const std::vector<std::array<std::uint16_t, 4>>& tets) {
  EdgeStar star;
  for (std::size_t i = 0; i < positions.size(); ++i)
    star.vertices.push_back({VertexId(100 + i), positions[i], 1, VertexKind::sample});
  for (std::size_t i = 0; i < tets.size(); ++i) {
    EdgeStar::StarTet t{TetId(i), tets[i]};
    const std::array<Vec3, 4> p = star.positions(t);
    if (orientation(p[0], p[1], p[2], p[3]) < 0) std::swap(t.v[2], t.v[3]);
    t.at_a = std::count(t.v.begin(), t.v.end(), 0) > 0;
    t.at_b = std::count(t.v.begin(), t.v.end(), 1) > 0;
    star.tets.push_back(t);
  }
  return star;
}

void embed(EdgeStar& star, const std::vector<int>& sides, const std::vector<std::uint16_t>& not_on_z) {
  star.form = ZeroForm::embedded;
  for (EdgeStar::StarVertex& v : star.vertices) v.value = 0;
  for (std::size_t i = 0; i < star.tets.size(); ++i) {
    star.tets[i].side = static_cast<std::int8_t>(sides[i]);
    for (const std::uint16_t v : star.tets[i].v) {
      if (std::find(not_on_z.begin(), not_on_z.end(), v) != not_on_z.end()) star.vertices[v].value = sides[i];
    }
  }
  for (EdgeStar::StarVertex& v : star.vertices) v.kind = v.value == 0 ? VertexKind::zero : VertexKind::sample;
}

EdgeStar bipyramid_star(std::size_t n) {
  std::vector<Vec3> p{{0, 0, 0.3}, {0, 0, -0.3}};
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    p.push_back({std::cos(angle), std::sin(angle), 0});
  }
  p.push_back({0, 0, 1});
  p.push_back({0, 0, -1});
  std::vector<std::array<std::uint16_t, 4>> tets;
  const auto ring = [n](std::size_t i) { return static_cast<std::uint16_t>(2 + i % n); };
  const auto top = static_cast<std::uint16_t>(2 + n), bottom = static_cast<std::uint16_t>(3 + n);
  for (std::size_t i = 0; i < n; ++i) tets.push_back({0, 1, ring(i), ring(i + 1)});
  for (std::size_t i = 0; i < n; ++i) tets.push_back({0, top, ring(i), ring(i + 1)});
  for (std::size_t i = 0; i < n; ++i) tets.push_back({1, bottom, ring(i), ring(i + 1)});
  return make_star(p, tets);
}

EdgeStar octahedron_star() {
  EdgeStar star = bipyramid_star(4);
  const std::array<Vec3, 4> exact{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, -1, 0}};
  for (std::size_t i = 0; i < 4; ++i) star.vertices[2 + i].position = exact[i];
  return star;
}

void transform(EdgeStar& star, double scale_x, double scale, Vec3 shift) {
  const auto map = [&](Vec3 p) { return Vec3{scale_x * p.x, scale * p.y, scale * p.z} + shift; };
  for (EdgeStar::StarVertex& v : star.vertices) v.position = map(v.position);
  for (Triangle3& t : star.cost_facets) {
    for (Vec3& p : t) p = map(p);
  }
}

EdgeStar star_of(const Complex& complex, VertexId a, VertexId b) {
  std::set<VertexId> others;
  std::vector<TetId> tets;
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    const auto& v = complex.tets[i].v;
    if (!complex.tets[i].alive()) continue;
    if (std::find(v.begin(), v.end(), a) == v.end() && std::find(v.begin(), v.end(), b) == v.end()) continue;
    tets.emplace_back(i);
    others.insert(v.begin(), v.end());
  }
  others.erase(a);
  others.erase(b);
  std::vector<VertexId> ids{a, b};
  ids.insert(ids.end(), others.begin(), others.end());
  std::vector<Vec3> positions;
  std::vector<std::array<std::uint16_t, 4>> local;
  for (const VertexId v : ids) positions.push_back(complex.position(v));
  for (const TetId t : tets) {
    auto& to = local.emplace_back();
    for (std::size_t k = 0; k < 4; ++k)
      to[k] =
          static_cast<std::uint16_t>(std::find(ids.begin(), ids.end(), complex.tet(t).v[k]) - ids.begin());
  }
  EdgeStar star = make_star(positions, local);
  for (std::size_t i = 0; i < ids.size(); ++i) star.vertices[i].id = ids[i];
  for (std::size_t i = 0; i < tets.size(); ++i) star.tets[i].id = tets[i];
  return star;
}

std::vector<std::pair<VertexId, VertexId>> inner_edges(const Complex& complex) {
  std::set<std::pair<VertexId, VertexId>> edges;
  for (const Tet& t : complex.tets) {
    if (!t.alive()) continue;
    for (const VertexId u : t.v) {
      for (const VertexId v : t.v) {
        const bool inner = complex.vertices[u.index()].kind != VertexKind::box &&
                           complex.vertices[v.index()].kind != VertexKind::box;
        if (u < v && inner) edges.insert({u, v});
      }
    }
  }
  return {edges.begin(), edges.end()};
}

std::vector<EdgeStar> random_stars(std::size_t n, std::size_t step, std::uint64_t seed) {
  const Box3 box{{-1, -1, -1}, {1, 1, 1}};
  const Grown grown = grow(box.grown(1), random_points(n, box, seed));
  const auto edges = inner_edges(grown.complex);
  std::vector<EdgeStar> stars;
  for (std::size_t i = 0; i < edges.size(); i += step)
    stars.push_back(star_of(grown.complex, edges[i].first, edges[i].second));
  return stars;
}

} // namespace isoscope::test
