// Facets that meet are found in strips of space as they are one pair at a time, on any number of threads.
#include "tolerance/self_intersections.h"

#include "base/parallel.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

std::vector<FacetPair> find(const TriangleSoup& soup, std::size_t most = ~std::size_t{0}) {
  const auto pairs = self_intersections(
      soup.points, soup.triangles, [] { return false; }, most);
  REQUIRE(pairs);
  return *pairs;
}

Box3 box_of(const TriangleSoup& soup, std::size_t f) {
  Box3 box;
  for (const Vec3 p : soup.triangle(f)) box.add(p);
  return box;
}

} // namespace

TEST_CASE("pairs of facets that meet are found across strips, each once") {
  TriangleSoup soup;
  add_sphere(soup, {0, 0, 0}, 1, 80);
  add_sphere(soup, {1.2, 0.1, 0}, 1, 80);
  soup.triangles.push_back({0, 1, 1}); // no area
  std::vector<std::uint32_t> order;    // facets by where they begin, so that few pairs are compared
  std::vector<Box3> boxes;
  for (std::uint32_t f = 0; f < soup.triangles.size(); ++f) {
    order.push_back(f);
    boxes.push_back(box_of(soup, f));
  }
  REQUIRE(soup.triangles.size() > 2 * 16384);
  std::sort(order.begin(), order.end(), [&](auto f, auto g) { return boxes[f].lo.z < boxes[g].lo.z; });
  std::vector<FacetPair> expected;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].lo.z <= boxes[order[i]].hi.z; ++j) {
      const auto [f, g] = std::minmax(order[i], order[j]);
      if (!boxes[f].meets(boxes[g]) || g + 1 == soup.triangles.size()) continue;
      const std::array two{soup.triangles[f], soup.triangles[g]};
      if (!self_intersections(soup.points, two, [] { return false; })->empty()) expected.emplace_back(f, g);
    }
  }
  const auto last = static_cast<std::uint32_t>(soup.triangles.size() - 1);
  expected.emplace_back(last, last);
  std::sort(expected.begin(), expected.end());
  CHECK(expected.size() > 100);
  for (const unsigned threads : {1u, 2u, 8u}) {
    const ThreadLimit limit(threads);
    CHECK(find(soup) == expected);
  }
}

TEST_CASE("the first pair is the same on any number of threads, and a stop ends the search") {
  TriangleSoup soup;
  add_sphere(soup, {0, 0, 0}, 1, 80);
  CHECK(find(soup).empty());
  add_sphere(soup, {1.2, 0.1, 0}, 1, 80);
  std::vector<FacetPair> first;
  for (const unsigned threads : {1u, 2u, 3u, 8u}) {
    const ThreadLimit limit(threads);
    const std::vector<FacetPair> found = find(soup, 1);
    REQUIRE(found.size() == 1);
    if (first.empty()) first = found;
    CHECK(found == first);
  }
  CHECK(!self_intersections(soup.points, soup.triangles, [] { return true; }));
  CHECK(find({}).empty());
}
