// Link condition, collapses, stars and patches on surfaces small enough to know by heart.
#include "improve/patch_moves.h"
#include "improve/support.h"
#include "tolerance/closest_point.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace isoscope;

namespace {

FacetComplex complex_of(const TriangleSoup& soup) {
  FacetComplex complex;
  complex.points = soup.points;
  for (const auto& t : soup.triangles) {
    Facet f;
    f.v = t;
    complex.facets.push_back(f);
  }
  complex.build_stars();
  return complex;
}

std::size_t alive_facets(const FacetComplex& complex) {
  return static_cast<std::size_t>(
      std::count_if(complex.facets.begin(), complex.facets.end(), [](const Facet& f) { return f.alive(); }));
}

/// Every directed edge once, with its opposite: a closed oriented surface.
bool is_closed(const FacetComplex& complex) {
  for (std::uint32_t f = 0; f < complex.facets.size(); ++f) {
    if (!complex.facets[f].alive()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& v = complex.facets[f].v;
      if (complex.facet_left_of(v[k], v[(k + 1) % 3]) != f) return false;
      if (complex.facet_left_of(v[(k + 1) % 3], v[k]) == Facet::none) return false;
    }
  }
  return true;
}

TriangleSoup tetrahedron() {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return soup;
}

} // namespace

TEST_CASE("no edge of a tetrahedron can be collapsed") {
  const FacetComplex complex = complex_of(tetrahedron());
  for (std::uint32_t a = 0; a < 4; ++a)
    for (std::uint32_t b = a + 1; b < 4; ++b) CHECK_FALSE(complex.link_condition(a, b));
}

TEST_CASE("an edge of the octahedron can be collapsed once, then down to the tetrahedron and no further") {
  FacetComplex complex = complex_of(testing::octahedron(1));
  REQUIRE(complex.link_condition(0, 2));
  CHECK(complex.merged_star(0, 2).size() == 4);
  complex.collapse(0, 2);
  CHECK(is_closed(complex));
  CHECK(alive_facets(complex) == 6);
  CHECK_FALSE(complex.alive_vertex(2));
  // The vertices 0 and 1 are now joined by an edge with two apexes, 4 and 5, of valence 4 and more.
  std::size_t possible = 0;
  for (std::uint32_t a = 0; a < 6; ++a)
    for (std::uint32_t b = a + 1; b < 6; ++b)
      if (complex.alive_vertex(a) && complex.alive_vertex(b) && complex.has_edge(a, b))
        possible += complex.link_condition(a, b) ? 1u : 0u;
  CHECK(possible > 0);
  REQUIRE(complex.link_condition(4, 1) != complex.link_condition(0, 1));
}

TEST_CASE("a three-cycle that bounds no facet blocks the collapse of its edges") {
  TriangleSoup soup;
  testing::add_torus(soup, {0, 0, 0}, 2, 0.5, 3); // the meridian circles are three-cycles
  const FacetComplex complex = complex_of(soup);
  REQUIRE(is_closed(complex));
  CHECK(complex.has_edge(0, 1));
  CHECK(complex.has_edge(1, 2));
  CHECK(complex.has_edge(2, 0));
  CHECK_FALSE(complex.link_condition(0, 1));
}

TEST_CASE("stars of a torus grid are cycles, and collapsing what may be collapsed keeps the torus") {
  TriangleSoup soup;
  testing::add_torus(soup, {0, 0, 0}, 2, 0.7, 8);
  FacetComplex complex = complex_of(soup);
  for (std::uint32_t v = 0; v < complex.points.size(); ++v) {
    const auto star = complex.star(v);
    CHECK(star.size() == 6);
    for (std::size_t i = 0; i < star.size(); ++i) CHECK(star[i].next == star[(i + 1) % star.size()].rim);
  }
  testing::Random random(3);
  std::size_t collapsed = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto f = random.below(complex.facets.size());
    if (!complex.facets[f].alive()) continue;
    const std::uint32_t a = complex.facets[f].v[0], b = complex.facets[f].v[1];
    if (!complex.link_condition(a, b)) continue;
    complex.collapse(a, b);
    ++collapsed;
  }
  CHECK(is_closed(complex));
  CHECK(alive_facets(complex) == soup.triangles.size() - 2 * collapsed);
  // A torus needs seven vertices; every collapse takes one.
  CHECK(soup.points.size() - collapsed >= 7);
  CHECK(collapsed > soup.points.size() / 2);
}

TEST_CASE("a patch knows what is free, what lies outside and what has changed") {
  TriangleSoup soup;
  testing::add_torus(soup, {0, 0, 0}, 2, 0.7, 8);
  const FacetComplex complex = complex_of(soup);
  const auto free_vertices = vertices_around(complex, {0, 1}, 1);
  CHECK(free_vertices.size() == 10);
  SurfacePatch patch = take_patch(complex, free_vertices);
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    const bool listed = std::binary_search(free_vertices.begin(), free_vertices.end(), patch.vertices[i]);
    CHECK((patch.free[i] != 0) == listed);
    CHECK(patch.valence(static_cast<std::uint32_t>(i)) == 6);
    if (listed) CHECK(patch.outside[i] == 0);
  }
  for (std::size_t f = 0; f < patch.slots.size(); ++f) {
    CHECK_FALSE(patch.changed(f));
    CHECK(patch.surface_corners(patch.complex.facets[f].v) == complex.facets[patch.slots[f]].v);
  }
  const std::uint32_t local = patch.local_vertex(0);
  patch.complex.points[local] = patch.complex.points[local] + Vec3{0.01, 0, 0};
  std::size_t changed = 0;
  for (std::size_t f = 0; f < patch.slots.size(); ++f) changed += patch.changed(f) ? 1u : 0u;
  CHECK(changed == 6);
}

TEST_CASE("a flip towards the better diagonal is taken, its reverse is not") {
  // A ridge along the x axis over an input that is the same ridge: the diagonal across it cuts through.
  TriangleSoup ridge;
  ridge.points = {{-1, 0, 0.2}, {1, 0, 0.2}, {0, -1, 0}, {0, 1, 0}, {-3, 0, 0.2}, {3, 0, 0.2}};
  ridge.triangles = {{0, 2, 1}, {0, 1, 3}, {4, 2, 0}, {4, 0, 3}, {1, 2, 5}, {1, 5, 3}};
  TriangleSoup across = ridge;
  across.triangles[0] = {2, 3, 0};
  across.triangles[1] = {3, 2, 1};
  const ClosestPointIndex index(ridge);
  for (const bool good : {true, false}) {
    const TriangleMesh mesh{ridge.points, good ? ridge.triangles : across.triangles};
    const InputSurface input(index, 0.15, mesh);
    FacetComplex complex = complex_of({mesh.points, mesh.triangles, {}});
    for (std::uint32_t f = 0; f < complex.facets.size(); ++f) measure_facet(input, complex, f);
    std::size_t k = 0;
    while (
        !(complex.facets[0].v[k] == (good ? 1u : 2u) || complex.facets[0].v[(k + 1) % 3] == (good ? 0u : 3u)))
      ++k;
    bool flipped = false;
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const auto plan = plan_flip(input, complex, 0, edge);
      if (!plan || plan->g != 1) continue;
      apply_flip(complex, *plan);
      flipped = true;
      break;
    }
    CHECK(flipped == !good);
    CHECK(complex.has_edge(0, 1));
  }
}
