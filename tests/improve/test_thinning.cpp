// What is merged before anything is asked: every step keeps the surface what it is, and only what is fine
// goes.
#include "improve/corner_table.h"
#include "improve/facet_complex.h"
#include "improve/sheet_cells.h"
#include "improve/support.h"
#include "improve/thinning.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>

using namespace isoscope;
using isoscope::testing::check_valid;
using isoscope::testing::Listener;
using isoscope::testing::octahedron;
using isoscope::testing::sphere;
using isoscope::testing::Start;

namespace {

ThinnedMesh thinned(const Start& start, Listener& listener, std::optional<ChangeBox> box = {},
                    std::vector<Vec3> kept = {}) {
  return thin(start.mesh, {start.volume->index(), start.delta(), kept, box}, RunControl(), listener);
}

/// A sphere whose vertices are off by a part of its edges.
TriangleSoup bumpy_sphere(unsigned n) {
  TriangleSoup soup = sphere(n);
  testing::Random random(7);
  for (Vec3& p : soup.points) p += 0.2 / n * std::hypot(p.x, p.y) * random.direction();
  return soup;
}

std::vector<std::array<std::uint32_t, 3>> facets_of(const CornerTable& table) {
  std::vector<std::array<std::uint32_t, 3>> facets;
  for (std::size_t f = 0; f < table.facets(); ++f)
    if (table.alive(f)) facets.push_back(table.facet(f));
  return facets;
}

} // namespace

TEST_CASE("Stars go around, and a collapse leaves the corners of the facets that stay") {
  const TriangleSoup soup = octahedron(1);
  CornerTable table(soup.triangles, soup.points.size());
  std::vector<std::uint32_t> star;
  for (std::uint32_t v = 0; v < 6; ++v) {
    table.star(v, star);
    REQUIRE(star.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(table.vertex(star[i]) == v);
      CHECK(table.vertex(CornerTable::previous(star[i])) ==
            table.vertex(CornerTable::next(star[(i + 1) % 4])));
    }
  }
  table.star(0, star);
  const auto to_2 = *std::find_if(star.begin(), star.end(),
                                  [&](std::uint32_t c) { return table.vertex(CornerTable::next(c)) == 2; });
  FacetComplex complex;
  complex.points = soup.points;
  for (const auto& t : soup.triangles) complex.facets.emplace_back().v = t;
  complex.build_stars();
  REQUIRE(complex.link_condition(2, 0));
  complex.collapse(2, 0);
  table.collapse(to_2);
  std::vector<std::array<std::uint32_t, 3>> expected;
  for (const Facet& f : complex.facets)
    if (f.alive()) expected.push_back(f.v);
  CHECK(facets_of(table) == expected);
  CHECK(!table.has_facets(0));
  for (const std::uint32_t v : {1u, 2u, 3u, 4u, 5u}) {
    table.star(v, star);
    CHECK(star.size() == complex.stars[v].size());
  }
}

TEST_CASE("Where a facet is missing there is no star") {
  TriangleSoup soup = octahedron(1);
  soup.triangles.pop_back(); // 0, 3, 5
  const CornerTable table(soup.triangles, soup.points.size());
  std::vector<std::uint32_t> star;
  for (std::uint32_t v = 0; v < 6; ++v) {
    table.star(v, star);
    CHECK(star.size() == (v == 0 || v == 3 || v == 5 ? 0 : 4));
  }
}

TEST_CASE("A facet looks in half of the directions, one turned over in the others, a needle in none") {
  const Triangle3 up{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}};
  const DirectionSet above = directions_of(up), below = directions_of({up[0], up[2], up[1]});
  CHECK(std::popcount(above) == 9);
  CHECK(std::popcount(below) == 9);
  CHECK((above & below) == 0);
  CHECK(directions_of({up[0], up[1], Vec3{2, 1e-12, 0}}) == 0);
  CHECK(directions_of({up[0], up[0], up[1]}) == 0);
}

TEST_CASE("Cells have the directions that all facets in them have, however large these are") {
  SheetCells cells(1);
  const auto at = [&](Vec3 p) { return cells.common(cells.range({p, p})); };
  CHECK(at({0.5, 0.5, 0.5}) == 0); // nobody has asked for it
  cells.add(cells.range({{0.5, 0.5, 0.5}, {9.5, 0.5, 1.5}}));
  CHECK(at({0.5, 0.5, 0.5}) == all_directions);
  const Triangle3 up{Vec3{-10, -10, 0.5}, Vec3{30, -10, 0.5}, Vec3{-10, 30, 0.5}};
  cells.restrict(up);
  CHECK(at({0.5, 0.5, 0.5}) == directions_of(up));
  CHECK(at({9.5, 0.5, 0.5}) == directions_of(up));
  CHECK(at({9.5, 0.5, 1}) == all_directions); // half-open
  CHECK(cells.common(cells.range({{0.5, 0.5, 0.5}, {1.5, 0.5, 1.5}})) == directions_of(up));
  cells.restrict(Triangle3{Vec3{1.2, 0.2, 0.8}, Vec3{1.2, 0.8, 0.8}, Vec3{1.8, 0.2, 0.8}});
  CHECK(at({1.5, 0.5, 0.5}) == 0); // two sheets
  CHECK(at({2.5, 0.5, 0.5}) == directions_of(up));
}

TEST_CASE("A fine sphere gets coarse at once, is what it was otherwise, and says each step") {
  for (const bool bumpy : {false, true}) {
    CAPTURE(bumpy);
    const Start start(bumpy ? bumpy_sphere(80) : sphere(80), 5);
    Listener listener;
    const ThinnedMesh coarse = thinned(start, listener);
    CHECK(coarse.mesh.triangles.size() * 3 < start.mesh.triangles.size());
    check_valid(coarse.mesh, start, 2);
    REQUIRE(coarse.vertices.size() == coarse.mesh.points.size());
    for (std::size_t v = 0; v < coarse.vertices.size(); ++v)
      CHECK(coarse.mesh.points[v] == start.mesh.points[coarse.vertices[v]]);
    std::map<std::uint32_t, std::array<std::uint32_t, 3>> facets;
    for (std::uint32_t f = 0; f < start.mesh.triangles.size(); ++f) facets[f] = start.mesh.triangles[f];
    for (const SurfaceChange& change : listener.changes) {
      for (const auto& f : change.removed) {
        CHECK(facets[f.slot] == f.v);
        facets.erase(f.slot);
      }
      for (const auto& f : change.added) facets[f.slot] = f.v;
      CHECK(change.killed_vertices.size() == 1);
      CHECK(change.moves.empty());
    }
    REQUIRE(facets.size() == coarse.facets.size());
    for (std::size_t f = 0; f < coarse.facets.size(); ++f) {
      auto v = coarse.mesh.triangles[f];
      for (std::uint32_t& w : v) w = coarse.vertices[w];
      CHECK(facets[coarse.facets[f]] == v);
    }
    for (const ImproverVerdict& verdict : listener.verdicts) {
      CHECK(verdict.value <= start.delta());
      CHECK(verdict.placed == Reason::halfedge);
    }
  }
}

TEST_CASE("Sheets nearer to each other than facets get long never meet") {
  TriangleSoup flat = bumpy_sphere(80);
  for (Vec3& p : flat.points) p.z *= 0.015;
  const Start start(flat, 5);
  Listener listener;
  const ThinnedMesh coarse = thinned(start, listener);
  CHECK(coarse.mesh.triangles.size() < start.mesh.triangles.size());
  check_valid(coarse.mesh, start, 2);
}

TEST_CASE("What is not wholly in the box stays, and so does what holds a point that is kept") {
  const Start start(sphere(80), 5);
  const ChangeBox box{{-2, -2, 0.3}, {2, 2, 2}};
  const Vec3 kept{0, 0, 0.999};
  Listener listener;
  const ThinnedMesh coarse = thinned(start, listener, box, {kept});
  CHECK(coarse.mesh.triangles.size() < start.mesh.triangles.size());
  std::vector<std::uint8_t> stays(start.mesh.points.size(), 0);
  for (const std::uint32_t v : coarse.vertices) stays[v] = 1;
  for (const auto& t : start.mesh.triangles)
    for (const std::uint32_t v : t)
      if (!std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t w) { return box.holds(start.mesh.points[w]); }) ||
          distance(start.mesh.points[v], kept) < 0.01)
        CHECK(stays[v] == 1);
}

TEST_CASE("What is as coarse as the tolerance, or would stop, is left") {
  const Start coarse(sphere(12), 1);
  Listener listener;
  CHECK(thinned(coarse, listener).mesh.triangles == coarse.mesh.triangles);
  CHECK(listener.changes.empty());
  const Start start(sphere(80), 5);
  listener.stop_after = 3;
  const ThinnedMesh stopped = thinned(start, listener);
  CHECK(stopped.stopped);
  CHECK(listener.changes.size() == 3);
  CHECK(stopped.mesh.triangles.size() == start.mesh.triangles.size() - 6);
}

TEST_CASE("The improver goes on from what was thinned, and tells of it in the ids that it was given") {
  const Start start(bumpy_sphere(60), 5);
  ImproverOptions options;
  options.effort = 1;
  options.preserve_normals = false;
  options.thin = true;
  TriangleMesh mesh = start.mesh;
  Listener listener;
  improve(mesh, *start.volume, nullptr, options, RunControl(), listener);
  check_valid(mesh, start, 2);
  CHECK(mesh.points.size() < 40);
  std::vector<Vec3> points = start.mesh.points;
  std::size_t alive = points.size();
  for (const SurfaceChange& change : listener.changes) {
    for (const auto& m : change.moves) {
      CHECK(points[m.vertex] == m.before);
      points[m.vertex] = m.after;
    }
    alive -= change.killed_vertices.size();
  }
  CHECK(alive == mesh.points.size());
  for (const Vec3 p : mesh.points) CHECK(std::find(points.begin(), points.end(), p) != points.end());
}
