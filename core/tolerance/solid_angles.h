// How often triangles that need not close wind around points: sums of solid angles, which gaps hardly change.
#pragma once

#include "base/geometry.h"
#include "tolerance/closest_point.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// The generalized winding number of a soup [Jacobson et al. 2013] by a tree whose far nodes count by the
/// first two terms of their series [Barill et al. 2018]. Immutable and thread-safe.
class SolidAngles {
 public:
  /// `turns`: how each triangle counts, by id, as in FacetTurns.
  SolidAngles(const ClosestPointIndex& index, std::span<const std::int8_t> turns);

  /// To a few hundredths; a whole number where the soup closes.
  double winding(Vec3 p) const;

 private:
  struct Facet {
    Triangle3 corners;
    double turn = 1;
  };
  /// Triangles as seen from afar: the first three terms of the series of their solid angle around a centre.
  struct Series {
    Vec3 area;                     ///< sum of area vectors n
    double trace = 0;              ///< of n·o, o the offset from the centre
    std::array<double, 6> slope{}; ///< of (n·u)(o·u) by products of two of u: xx, yy, zz, xy, xz, yz
    Vec3 linear;                   ///< of 2(n·o) o + (o·o) n
    /// Of (n·u)(o·u)² by products of three: xxx, yyy, zzz, xxy, xxz, xyy, yyz, xzz, yzz, xyz.
    std::array<double, 10> bend{};

    void add(const Triangle3& t, double turn, Vec3 center);
    /// The solid angle seen from -r u from the centre, for a unit vector u.
    double angle(Vec3 u, double r) const;
  };
  struct Node {
    Vec3 center;       ///< mean of its triangles, by area
    double radius = 0; ///< of a ball around the centre that holds them
    Series series;
    std::uint32_t first = 0, last = 0; ///< its triangles
    std::uint32_t second = 0;          ///< its second child; the first stands behind it; 0: a leaf
  };
  std::vector<Facet> facets_;
  std::vector<Node> nodes_; ///< empty where there are no triangles

  void build(std::uint32_t first, std::uint32_t last);
};

} // namespace isoscope
