// The octree of the complement of Ω': the same on any number of threads, its regions and floods those of a
// plain lattice.
#include "tolerance/regions.h"

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "support/clouds.h"
#include "tolerance/closest_point.h"
#include "tolerance/shapes.h"
#include "tolerance/weighted_points.h"

#include <doctest/doctest.h>

#include <map>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

using Index = Regions::CellIndex;
using Kind = Regions::Kind;

constexpr double boundary = 0.12;
constexpr Regions::Options options{.boundary = boundary, .main_side = 0.12, .min_side = 0.03, .margin = 0.3};

Regions octree_of(const ToleranceField& field, const Regions::Options& how = options) {
  auto built = Regions::build(field, how, RunControl());
  REQUIRE(built.ok());
  return std::move(built).value();
}

void add_rectangle(TriangleSoup& soup, Vec3 a, Vec3 u, Vec3 v) {
  const auto base = static_cast<std::uint32_t>(soup.points.size());
  for (const Vec3 p : {a, a + u, a + u + v, a + v}) soup.points.push_back(p);
  soup.triangles.push_back({base, base + 1, base + 2});
  soup.triangles.push_back({base, base + 2, base + 3});
}

/// The walls of a unit cube, with a slit of this width all across the upper one.
TriangleSoup room_with_slit(double width) {
  TriangleSoup soup;
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  add_rectangle(soup, {}, x, y);
  add_rectangle(soup, {}, x, z);
  add_rectangle(soup, {}, y, z);
  add_rectangle(soup, y, x, z);
  add_rectangle(soup, x, y, z);
  const double wall = 0.5 * (1 - width);
  add_rectangle(soup, z, wall * x, y);
  add_rectangle(soup, z + (1 - wall) * x, wall * x, y);
  return soup;
}

/// Whether two points are joined by OUT cells of the finest lattice that the octree may come to.
bool joined_in_lattice(const ToleranceField& field, const Regions& octree, Vec3 p, Vec3 q) {
  unsigned level = octree.main_level();
  while (octree.side(level) > options.min_side) ++level;
  const std::size_t n = std::size_t{1} << level;
  const double side = octree.side(level);
  std::vector<char> out(n * n * n);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Vec3 at{static_cast<double>(i % n) + 0.5, static_cast<double>(i / n % n) + 0.5,
                  static_cast<double>(i / (n * n)) + 0.5};
    out[i] = field.distance(octree.origin() + side * at) > boundary + 0.5 * std::sqrt(3.0) * side ? 1 : 0;
  }
  DisjointSets sets(out.size());
  const std::array<std::size_t, 3> strides{1, n, n * n};
  for (std::size_t i = 0; i < out.size(); ++i)
    for (const std::size_t stride : strides)
      if (i / stride % n > 0 && out[i] && out[i - stride])
        sets.unite(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i - stride));
  const auto cell_of = [&](Vec3 r) {
    std::size_t i = 0;
    for (int a = 0; a < 3; ++a)
      i += strides[static_cast<std::size_t>(a)] * static_cast<std::size_t>((r - octree.origin())[a] / side);
    return static_cast<std::uint32_t>(i);
  };
  return sets.find(cell_of(p)) == sets.find(cell_of(q));
}

bool same_cell(const Regions::Cell& a, const Regions::Cell& b) {
  return std::tie(a.x, a.y, a.z, a.child, a.triangle, a.distance, a.level, a.kind) ==
         std::tie(b.x, b.y, b.z, b.child, b.triangle, b.distance, b.level, b.kind);
}

void check_threads(const ToleranceField& field, const Regions::Options& how) {
  std::optional<Regions> first;
  for (const unsigned threads : {1u, 2u, 3u, 8u}) {
    CAPTURE(threads);
    const ThreadLimit limit(threads);
    Regions octree = octree_of(field, how);
    if (!first) {
      first.emplace(std::move(octree));
      continue;
    }
    REQUIRE(octree.size() == first->size());
    std::size_t different = 0;
    for (Index i = 0; i < octree.size(); ++i)
      different += same_cell(octree.cell(i), first->cell(i)) && octree.root(i) == first->root(i) ? 0u : 1u;
    CHECK(different == 0);
  }
}

} // namespace

TEST_CASE("the octree is the same on any number of threads") {
  TriangleSoup soup;
  add_torus(soup, {0, 0, 0}, 1, 0.4, 48);
  add_sphere(soup, {0, 0, 0}, 0.25, 24);
  check_threads(ClosestPointIndex(soup),
                {.boundary = 0.03, .main_side = 0.015, .min_side = 0.002, .margin = 0.1});
  Random random(4);
  std::vector<WeightedPoint> sites;
  for (const Vec3 p : sphere_points(random, 20000, 1, 0.02)) sites.push_back({p, 1e-4 * random.unit()});
  check_threads(WeightedPointIndex(sites, 12),
                {.boundary = 0.05, .main_side = 0.025, .min_side = 0.003, .margin = 0.15});
}

TEST_CASE("cells are halves of their parents, hold their centres, and are of the kind that φ there proves") {
  const ClosestPointIndex index(room_with_slit(0.3));
  Regions octree = octree_of(index);
  octree.locate_refining({0.5, 0.5, 1.1}); // some finer ones
  std::size_t leaves = 0, split = 0;
  for (Index i = 0; i < octree.size(); ++i) {
    const Regions::Cell c = octree.cell(i);
    const Vec3 center = octree.center(c);
    CHECK(octree.kind(i) == c.kind);
    CHECK(octree.child(i) == c.child);
    CHECK(octree.distance(i) == c.distance);
    CHECK(c.distance == static_cast<float>(index.distance(center)));
    const double reach = 0.5 * std::sqrt(3.0) * octree.side(c.level), d = index.distance(center);
    CHECK(c.kind == (d > boundary + reach ? Kind::out : d + reach <= boundary ? Kind::in : Kind::ambiguous));
    if (c.child == Regions::none) {
      ++leaves;
      CHECK(octree.locate(center) == i);
      continue;
    }
    ++split;
    for (unsigned k = 0; k < 8; ++k) {
      const Regions::Cell child = octree.cell(c.child + k);
      CHECK(child.level == c.level + 1);
      CHECK(std::array{child.x, child.y, child.z} ==
            std::array{2 * c.x + (k & 1u), 2 * c.y + (k >> 1 & 1u), 2 * c.z + (k >> 2)});
    }
  }
  CHECK(leaves + split == octree.size());
  CHECK(static_cast<double>(octree.memory_bytes()) <
        1.1 * Regions::bytes_of_cell * static_cast<double>(octree.size() + 8));
  CHECK(Regions::bytes_of_cell <= 16);
  CHECK(octree.size() > octree.main_size());
}

TEST_CASE("regions of the main cells are those of all pairs of OUT cells with a common face") {
  const ClosestPointIndex index(room_with_slit(0.3));
  const Regions octree = octree_of(index);
  std::vector<Index> out;
  for (Index i = 0; i < octree.size(); ++i)
    if (octree.kind(i) == Kind::out) out.push_back(i);
  DisjointSets sets(octree.size());
  for (const Index i : out)
    for (const Index j : out) {
      if (j >= i) break;
      const Regions::Cell a = octree.cell(i), b = octree.cell(j);
      const double apart = 0.5 * (octree.side(a.level) + octree.side(b.level));
      int across = 0, within = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double d = std::abs(octree.center(a)[axis] - octree.center(b)[axis]);
        across += std::abs(d - apart) < 1e-9 ? 1 : 0;
        within += d < apart - 1e-9 ? 1 : 0;
      }
      if (across == 1 && within == 2) sets.unite(i, j);
    }
  for (const Index i : out) CHECK(octree.root(i) == sets.find(i));
}

TEST_CASE("a flood through small cells joins what a lattice of them joins") {
  std::size_t found = 0, real = 0;
  for (const double width : {0.2, 0.26, 0.28, 0.3, 0.32, 0.35, 0.4}) {
    CAPTURE(width);
    const ClosestPointIndex index(room_with_slit(width));
    Regions octree = octree_of(index);
    const Vec3 inside{0.5, 0.5, 0.5}, outside{0.5, 0.5, 1.38};
    const bool joined = joined_in_lattice(index, octree, inside, outside);
    const Index from = octree.locate(inside), to = octree.locate(outside);
    REQUIRE(octree.kind(from) == Kind::out);
    REQUIRE(octree.kind(to) == Kind::out);
    const bool known = octree.root(from) == octree.root(to);
    octree.set_number(to, 7);
    const bool met = !known && octree.flood(from, 1000000, RunControl());
    CHECK((known || met) == joined);
    CHECK((octree.root(from) == octree.root(to)) == joined);
    CHECK(octree.number(from).has_value() == joined);
    found += met ? 1 : 0;
    real += joined ? 0 : 1;
  }
  CHECK(found >= 2); // that the main cells did not show
  CHECK(real >= 2);
}
