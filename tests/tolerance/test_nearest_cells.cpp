// Cells answer as a look at all triangles does, to the last bit.
#include "base/parallel.h"
#include "base/scramble.h"
#include "tolerance/nearest_cells.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

/// Evenly in [0, 1).
class Draws {
 public:
  double next() { return static_cast<double>(scrambled(state_ += golden_step) >> 11) * 0x1p-53; }
  Vec3 point(double scale) { return scale * Vec3{next() - 0.5, next() - 0.5, next() - 0.5}; }

 private:
  std::uint64_t state_ = 7;
};

/// Small triangles all over a cube, some of them segments or points.
TriangleSoup crumbs(std::size_t count, double size) {
  Draws draws;
  TriangleSoup soup;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 a = draws.point(2), b = a + draws.point(size), c = a + draws.point(size);
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    soup.points.insert(soup.points.end(), {a, b, i % 7 == 0 ? a : c});
    if (i % 21 == 0) soup.points[first + 1] = a;
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// A square of n x n cells of two triangles, in which corners have many nearest triangles.
TriangleSoup checkered(std::uint32_t n) {
  TriangleSoup soup;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      soup.points.push_back({double(x), double(y), 0.25 * ((x + y) % 2)});
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t at = y * (n + 1) + x;
      soup.triangles.push_back({at, at + 1, at + n + 2});
      soup.triangles.push_back({at, at + n + 2, at + n + 1});
    }
  return soup;
}

/// The nearest triangle by looking at all of them.
ClosestPoint by_looking_at_all(const ClosestPointIndex& index, Vec3 p) {
  ClosestPoint best;
  for (std::size_t t = 0; t < index.size(); ++t) {
    const ClosestPoint found = index.at_site(p, TriangleId(t));
    if (found.squared_distance < best.squared_distance) best = found;
  }
  return best;
}

void check_answers(const TriangleSoup& soup, double side, double reach, std::size_t queries,
                   std::size_t byte_limit = NearestCells::most_bytes) {
  const ClosestPointIndex index(soup);
  const NearestCells cells(index, side, byte_limit);
  Draws draws;
  const Vec3 center = index.bounds().center();
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < queries; ++i) {
    Vec3 p = center + draws.point(reach);
    // Also on the input, where many distances are 0 or equal.
    if (i % 4 == 1) p = index.closest(p).point;
    if (i % 4 == 2) p = soup.points[i % soup.points.size()];
    const ClosestPoint expected = by_looking_at_all(index, p);
    const TriangleId guess = i % 3 == 0 ? TriangleId() : TriangleId(i % index.size());
    for (const ClosestPoint& found : {cells.closest(p), cells.closest_near(p, guess)}) {
      const bool same = found.squared_distance == expected.squared_distance &&
                        found.triangle == expected.triangle && found.point == expected.point;
      wrong += same ? 0u : 1u;
    }
  }
  CHECK(wrong == 0);
}

} // namespace

TEST_CASE("cells give the nearest triangle, of several the one with the smallest id") {
  for (const double side : {0.02, 0.1, 0.5, 5.0}) check_answers(crumbs(400, 0.2), side, 3, 400);
  for (const double side : {0.3, 1.0, 3.0}) check_answers(checkered(12), side, 16, 600);
  check_answers(crumbs(3000, 0.02), 0.4, 2, 200); // cells have to be divided
}

TEST_CASE("points without a cell are looked up in the index") {
  check_answers(crumbs(300, 0.2), 0.1, 40, 200);   // most lie far outside
  check_answers(crumbs(300, 0.2), 0.1, 2, 200, 0); // no memory for cells
  check_answers(crumbs(1, 0.2), 0.1, 2, 50);
  const ClosestPointIndex nothing(TriangleSoup{});
  const NearestCells cells(nothing, 1);
  CHECK(cells.empty());
  CHECK_FALSE(cells.closest({}).triangle.valid());
}

TEST_CASE("cells are the same, and small, far from the origin and at any scale") {
  for (const double scale : {1e-9, 1e9}) {
    TriangleSoup soup = crumbs(200, 0.2);
    for (Vec3& p : soup.points) p = scale * p;
    check_answers(soup, 0.2 * scale, 3 * scale, 200);
  }
  TriangleSoup soup = crumbs(200, 0.2);
  for (Vec3& p : soup.points) p = p + Vec3{1e6, -1e6, 1e6};
  check_answers(soup, 0.2, 3, 200);
}

TEST_CASE("threads that ask at once get the same answers and share the cells") {
  const TriangleSoup soup = crumbs(500, 0.2);
  const ClosestPointIndex index(soup);
  std::vector<Vec3> points;
  Draws draws;
  for (int i = 0; i < 4000; ++i) points.push_back(draws.point(2));
  const auto answers = [&](const NearestCells& cells) {
    std::vector<std::uint32_t> found(points.size());
    parallel_for(points.size(), 1,
                 [&](std::size_t i) { found[i] = cells.closest(points[i]).triangle.value; });
    return found;
  };
  const NearestCells cells(index, 0.1), others(index, 0.3);
  CHECK(answers(cells) == answers(others));
  const std::size_t bytes = cells.memory_bytes();
  CHECK(bytes > 0);
  answers(cells);
  CHECK(cells.memory_bytes() == bytes);
}
