// Patches side by side are turned to run one way along the seams that Ω closes, and only there.
#include "tolerance/facet_turns.h"
#include "tolerance/patch_seams.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace isoscope;

namespace {

/// A rectangle of n x m cells in the plane z = 0 over x from `x`, folded up by `rise` a unit of x; turned: it
/// runs the other way round.
void add_strip(TriangleSoup& soup, double x, double width, int n, int m, bool turned, double rise = 0) {
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) {
      const double along = width * i / n;
      soup.points.push_back({x + along, 1.0 * j / m, rise * along});
    }
  const auto at = [&](int i, int j) { return first + static_cast<std::uint32_t>(i * (m + 1) + j); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      std::array<std::array<std::uint32_t, 3>, 2> both{
          {{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, {at(i, j), at(i + 1, j + 1), at(i, j + 1)}}};
      for (auto& t : both) {
        if (turned) std::swap(t[1], t[2]);
        soup.triangles.push_back(t);
      }
    }
}

std::vector<std::int8_t> turns_of(const TriangleSoup& soup, double boundary) {
  const ClosestPointIndex index(soup);
  const WeldedMesh mesh = weld(index);
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  PatchTurns patches = orient_patches(mesh, uses);
  REQUIRE_FALSE(patches.one_sided);
  turn_along_seams(index, mesh, uses, boundary, patches.turns);
  return patches.turns;
}

/// Which way the first triangles of the strips run then, relative to the first strip's.
std::vector<int> ways(const TriangleSoup& soup, const std::vector<std::size_t>& firsts, double boundary) {
  const std::vector<std::int8_t> turns = turns_of(soup, boundary);
  std::vector<int> ways;
  for (const std::size_t t : firsts) ways.push_back(turns[t]);
  return ways;
}

} // namespace

TEST_CASE("A patch that runs the other way is turned, whatever the triangles at the seam are") {
  for (const double rise : {0.0, 1.0, -20.0}) { // the steep one is the larger
    TriangleSoup soup;
    add_strip(soup, 0, 1, 3, 4, false);
    add_strip(soup, 1, 0.5, 2, 7, true, rise);
    const std::vector<int> found = ways(soup, {0, 24}, 0.1);
    CHECK(found == (std::abs(rise) > 2 ? std::vector<int>{-1, 1} : std::vector<int>{1, -1}));
    // The larger part stays as it is given.
    TriangleSoup other;
    add_strip(other, 0, 0.5, 2, 7, true);
    add_strip(other, 0.5, 1, 3, 4, false);
    CHECK(ways(other, {0, 28}, 0.1) == std::vector<int>{-1, 1});
  }
}

TEST_CASE("Patches that agree, or lie apart, stay as they are") {
  TriangleSoup soup;
  add_strip(soup, 0, 1, 3, 4, false);
  add_strip(soup, 1, 1, 3, 7, false);
  add_strip(soup, 2.3, 1, 3, 7, true);
  CHECK(ways(soup, {0, 24, 66}, 0.1) == std::vector<int>{1, 1, 1});
  // A slit that Ω closes is a seam.
  CHECK(ways(soup, {0, 24, 66}, 0.4) == std::vector<int>{1, 1, -1});
}

TEST_CASE("A chain of patches is turned as one") {
  TriangleSoup soup;
  std::vector<std::size_t> firsts;
  for (int i = 0; i < 6; ++i) {
    firsts.push_back(soup.triangles.size());
    add_strip(soup, i, 1, 1, 2 + i % 3, i % 2 != 0);
  }
  const std::vector<int> found = ways(soup, firsts, 0.1);
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] * found[0] == (i % 2 == 0 ? 1 : -1));
}
