// The input as the improver sees it: distances with their directions, normals oriented like Z.
#pragma once

#include "base/geometry.h"
#include "base/run_control.h"
#include "input/triangle_soup.h"
#include "tolerance/closest_point.h"

#include <vector>

namespace isoscope {

/// d at a point, to first order.
struct DistanceSample {
  double distance = 0;
  Vec3 direction; ///< ∇d, of length 1; on the input the normal of its triangle
  TriangleId triangle;
};

/// Distances to the input in units of the run, and the input's unit normals on the side of Z's.
class InputSurface {
 public:
  /// Normals are oriented by `surface`: pieces of the input whose triangles agree with each other vote with
  /// the nearest facets of the surface, so that an input in any orientation serves. They stay as they are
  /// where the surface is empty, and are of no use once the control is cancelled.
  InputSurface(const ClosestPointIndex& index, double delta, const TriangleMesh& surface,
               const RunControl& control = {});

  /// d at p, starting from a triangle that is likely close (or an invalid one). Where d is far below δ, so
  /// that it has no weight in an energy, the distance to that triangle may be returned instead.
  DistanceSample sample(Vec3 p, TriangleId guess) const {
    if (guess.valid()) {
      const Vec3 c = closest_point_on_triangle(p, index_->triangle(guess));
      const double d2 = squared_length(p - c);
      const ClosestPoint found{c, d2, guess};
      return sample(p, d2 < enough_ * enough_ ? found : index_->closest_near(p, found, enough_));
    }
    return sample(p, index_->closest(p));
  }
  Vec3 normal(TriangleId t) const { return normals_[t.index()]; }
  double delta() const { return delta_; }
  const ClosestPointIndex& index() const { return *index_; }

 private:
  DistanceSample sample(Vec3 p, const ClosestPoint& c) const {
    const double d = c.distance();
    return {d, d > on_surface_ ? (p - c.point) / d : normal(c.triangle), c.triangle};
  }

  const ClosestPointIndex* index_;
  double delta_, on_surface_, enough_;
  std::vector<Vec3> normals_; ///< by triangle id; zero for degenerate triangles
};

} // namespace isoscope
