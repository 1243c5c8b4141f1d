// Small point sets and triangulations for the tests of core/mesh.
#pragma once

#include "mesh/complex.h"
#include "mesh/delaunay.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace isoscope::test {

/// A fixed generator, the same on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  Vec3 in(const Box3& box);

 private:
  std::uint64_t state_;
};

/// Corners of a box with value 1.
std::vector<Vertex> box_corners(const Box3& box);
std::vector<Vec3> random_points(std::size_t n, const Box3& box, std::uint64_t seed);
/// n³ points with coordinates 0 … n − 1, in random order.
std::vector<Vec3> lattice_points(int n, std::uint64_t seed);
/// Points with integer coordinates on the sphere of radius 25 about 0: exactly cospherical, in random order.
std::vector<Vec3> cospherical_points(std::uint64_t seed);

/// A grid of n³ points in T, embedded by hand: each tetrahedron has the side that `side` gives to its
/// centroid, and facets between two sides are dropped where `is_dropped` says so of theirs.
Complex lattice_with_sides(int n, const std::function<int(Vec3)>& side,
                           const std::function<bool(Vec3)>& is_dropped);

/// A triangulation with the deltas that made it.
struct Grown {
  Delaunay delaunay;
  Complex complex;
  std::vector<Delta> deltas;
  std::size_t refused = 0;

  explicit Grown(const Box3& box);
  /// Inserts and applies; whether anything changed.
  bool insert(Vec3 p, double value = 1);
  TetId some_tet() const;
};
Grown grow(
    const Box3& box, const std::vector<Vec3>& points,
    const std::function<double(Vec3)>& label = [](Vec3) { return 1.0; });

} // namespace isoscope::test
