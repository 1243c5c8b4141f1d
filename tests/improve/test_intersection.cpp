// Pairs of facets with known answers, the octree against brute force, and swept witnesses.
#include "base/solid_angle.h"
#include "improve/facet_intersection.h"
#include "improve/facet_octree.h"
#include "improve/swept_witness.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace isoscope;
using isoscope::testing::Random;

namespace {

struct Pair {
  const char* what;
  IndexedTriangle a, b;
  bool meets;
};

/// The triangle 0 1 2 in the plane z = 0.
IndexedTriangle base() {
  return {{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}}, {0, 1, 2}};
}

} // namespace

TEST_CASE("facets meet properly exactly when the table says so") {
  const Vec3 a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  const std::vector<Pair> table{
      {"apart", base(), {{Vec3{9, 9, 9}, Vec3{10, 9, 9}, Vec3{9, 10, 9}}, {3, 4, 5}}, false},
      {"parallel planes", base(), {{Vec3{0, 0, 1}, Vec3{4, 0, 1}, Vec3{0, 4, 1}}, {3, 4, 5}}, false},
      {"crossing", base(), {{Vec3{1, 1, -1}, Vec3{1, 1, 1}, Vec3{2, 1, 1}}, {3, 4, 5}}, true},
      {"a corner touches the inside",
       base(),
       {{Vec3{1, 1, 0}, Vec3{1, 1, 1}, Vec3{2, 1, 1}}, {3, 4, 5}},
       true},
      {"a corner just above", base(), {{Vec3{1, 1, 1e-300}, Vec3{1, 1, 1}, Vec3{2, 1, 1}}, {3, 4, 5}}, false},
      {"equal positions, other ids", base(), {{a, Vec3{-1, 0, 1}, Vec3{0, -1, 1}}, {3, 4, 5}}, true},
      {"coplanar overlap", base(), {{Vec3{1, 1, 0}, Vec3{5, 1, 0}, Vec3{1, 5, 0}}, {3, 4, 5}}, true},
      {"coplanar inside", base(), {{Vec3{.5, .5, 0}, Vec3{1, .5, 0}, Vec3{.5, 1, 0}}, {3, 4, 5}}, true},
      {"coplanar apart", base(), {{Vec3{5, 5, 0}, Vec3{9, 5, 0}, Vec3{5, 9, 0}}, {3, 4, 5}}, false},
      {"shared vertex only", base(), {{a, Vec3{-1, 0, 1}, Vec3{0, -1, 1}}, {0, 4, 5}}, false},
      {"shared vertex, edge through the inside",
       base(),
       {{a, Vec3{1, 1, -1}, Vec3{1, 1, 1}}, {0, 4, 5}},
       true},
      {"shared vertex, coplanar overlap", base(), {{a, Vec3{4, 1, 0}, Vec3{1, 4, 0}}, {0, 4, 5}}, true},
      {"shared vertex, coplanar neighbours", base(), {{a, Vec3{-4, 0, 0}, Vec3{0, -4, 0}}, {0, 4, 5}}, false},
      {"shared vertex, edges along each other",
       base(),
       {{a, Vec3{2, 0, 0}, Vec3{0, -4, 0}}, {0, 4, 5}},
       true},
      {"shared edge, a fold of any angle", base(), {{b, a, Vec3{1, 1, 1}}, {1, 0, 5}}, false},
      {"shared edge, coplanar neighbours", base(), {{b, a, Vec3{1, -3, 0}}, {1, 0, 5}}, false},
      {"shared edge, folded flat", base(), {{b, a, Vec3{1, 3, 0}}, {1, 0, 5}}, true},
      {"shared edge, almost folded flat", base(), {{b, a, Vec3{1, 3, 1e-300}}, {1, 0, 5}}, false},
      {"the same vertices", base(), {{b, a, c}, {1, 0, 2}}, true},
  };
  for (const Pair& pair : table) {
    CAPTURE(pair.what);
    CHECK(intersect_properly(pair.a, pair.b) == pair.meets);
    CHECK(intersect_properly(pair.b, pair.a) == pair.meets);
  }
}

TEST_CASE("facets on a line are degenerate, others are not") {
  CHECK(is_degenerate({Vec3{0, 0, 0}, Vec3{1, 1, 1}, Vec3{3, 3, 3}}));
  CHECK(is_degenerate({Vec3{1, 2, 3}, Vec3{1, 2, 3}, Vec3{0, 0, 0}}));
  CHECK_FALSE(is_degenerate({Vec3{0, 0, 0}, Vec3{1, 1, 1}, Vec3{3, 3, std::nextafter(3.0, 4.0)}}));
}

TEST_CASE("the octree finds every box that overlaps, through insertions and removals") {
  Random random(8);
  const Box3 domain{{0, 0, 0}, {10, 10, 10}};
  FacetOctree octree(domain);
  std::vector<Box3> boxes;
  std::vector<bool> inside;
  const auto overlap = [](const Box3& a, const Box3& b) {
    for (int k = 0; k < 3; ++k)
      if (a.lo[k] > b.hi[k] || b.lo[k] > a.hi[k]) return false;
    return true;
  };
  for (int i = 0; i < 600; ++i) {
    Box3 box;
    box.add(random.in_box(domain));
    const double size = std::pow(10, random.between(-4, 0.9));
    box.add(box.lo + size * Vec3{random.unit(), random.unit(), random.unit()});
    boxes.push_back(box);
    inside.push_back(true);
    octree.insert(static_cast<std::uint32_t>(i), box);
  }
  for (std::uint32_t i = 0; i < boxes.size(); i += 3) {
    octree.erase(i, boxes[i]);
    inside[i] = false;
  }
  for (int i = 0; i < 200; ++i) {
    Box3 query;
    query.add(random.in_box(domain));
    query.add(query.lo + random.between(0, 2) * Vec3{1, 1, 1});
    std::vector<std::uint32_t> found;
    octree.visit(query, [&](std::uint32_t f) {
      if (overlap(query, boxes[f])) found.push_back(f);
      return false;
    });
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> expected;
    for (std::uint32_t f = 0; f < boxes.size(); ++f)
      if (inside[f] && overlap(query, boxes[f])) expected.push_back(f);
    CHECK(found == expected);
  }
}

TEST_CASE("a witness between an old and a new cap is swept, one outside or behind is not") {
  const Vec3 a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  const auto cap = [&](Vec3 apex) {
    return std::vector<Triangle3>{{a, b, apex}, {b, c, apex}, {c, a, apex}};
  };
  const auto low = cap({1, 1, 1}), high = cap({1, 1, 3});
  const std::vector<Vec3> between{{1, 1, 2}}, under{{1, 1, 0.5}}, beside{{3, 3, 2}};
  CHECK(swept_witness(between, low, high).has_value());
  CHECK(swept_witness(between, high, low).has_value());
  CHECK_FALSE(swept_witness(under, low, high).has_value());
  CHECK_FALSE(swept_witness(beside, low, high).has_value());
  CHECK_FALSE(swept_witness({}, low, high).has_value());
  double whole = 0;
  for (const Triangle3& t : cap({1, 1, 1})) whole += solid_angle({1, 1, 0.5}, t);
  whole += solid_angle({1, 1, 0.5}, {a, c, b});
  CHECK(std::abs(whole) == doctest::Approx(4 * std::numbers::pi));
}
