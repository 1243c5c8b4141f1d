// The witnessed k-distance of points (Guibas, Mérigot, Morozov 2013): weighted points whose φ is near to a
// surface only where many points are, so that noise is evened out and outliers vanish (core/README.md, N1).
#pragma once

#include "base/run_control.h"
#include "input/triangle_soup.h"
#include "tolerance/weighted_points.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// A site a point: the mean of the k points nearest to it, itself among them, and their mean squared distance
/// from that mean. Its φ is nowhere below the distance to the measure of the points (of mass k/n), so that
/// what is proven of φ holds for that.
struct WitnessedDistance {
  std::vector<WeightedPoint> sites; ///< by point
  std::size_t neighbors = 0;        ///< k
  bool automatic = false;           ///< k was chosen here
  double outlying = 0;              ///< the share of points that stand far from all others
  double area = 0;    ///< about that of the surface that the points are on, outlying ones left out
  double spacing = 0; ///< the typical distance between neighbours on it

  /// Below this φ tells how the points lie rather than how the surface does.
  double finest() const;
};

/// k where none is given, and where more than a twentieth of the points is outlying.
constexpr std::size_t usual_neighbors = 12, robust_neighbors = 40;

/// `neighbors`: k, at most the number of points; 1 gives the plain distance to the points; 0: chosen by the
/// share of outlying points. Of no use once the control is cancelled. The same on any number of threads.
WitnessedDistance witness_distance(std::span<const Vec3> points, std::size_t neighbors,
                                   const RunControl& control);

/// `n` points evenly on the triangles of a soup, one in each n-th part of its area, by draws from the seed.
std::vector<Vec3> sample_area(const TriangleSoup& soup, std::size_t n, std::uint64_t seed);

} // namespace isoscope
