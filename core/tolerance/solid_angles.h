// How often triangles that need not close wind around points: sums of solid angles, which gaps hardly change.
#pragma once

#include "base/geometry.h"
#include "tolerance/closest_point.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// The generalized winding number of a soup [Jacobson et al. 2013] by a tree whose far nodes count as dipoles
/// [Barill et al. 2018]. Immutable and thread-safe.
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
  struct Node {
    Vec3 center;                       ///< mean of its triangles, by area
    Vec3 area;                         ///< sum of their area vectors
    double radius = 0;                 ///< of a ball around the centre that holds them
    std::uint32_t first = 0, last = 0; ///< its triangles
    std::uint32_t second = 0;          ///< its second child; the first stands behind it; 0: a leaf
  };
  std::vector<Facet> facets_;
  std::vector<Node> nodes_; ///< empty where there are no triangles

  void build(std::uint32_t first, std::uint32_t last);
};

} // namespace isoscope
