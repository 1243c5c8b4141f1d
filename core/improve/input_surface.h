// The input as the improver sees it: φ with its gradient, normals oriented like Z.
#pragma once

#include "base/geometry.h"
#include "base/run_control.h"
#include "improve/room_distance.h"
#include "input/triangle_soup.h"
#include "tolerance/field.h"
#include "tolerance/flat_parts.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

/// φ at a point, to first order.
struct DistanceSample {
  double distance = 0;
  Vec3 direction; ///< ∇φ; on the input the normal of its triangle
  TriangleId triangle;
};

class BorderGate;

/// φ in units of the run, and the input's unit normals on the side of Z's.
class InputSurface {
 public:
  enum class Normals : std::uint8_t { like_surface, as_given };
  /// Normals are as the triangles run, or oriented by `surface`: pieces of the input whose triangles agree
  /// with each other vote with the nearest facets of the surface, so that an input in any orientation serves.
  /// They stay as they are where the surface is empty, and are of no use once the control is cancelled. A
  /// field without triangles has the normals of the facets of the surface that are nearest to its sites.
  /// `gate`: the open rim of the input; null where the surface is closed.
  InputSurface(const ToleranceField& field, double delta, const TriangleMesh& surface,
               const RunControl& control = {}, const BorderGate* gate = nullptr,
               Normals normals = Normals::like_surface);

  /// φ at p, starting from a site that is likely close (or an invalid one). Where φ is far below δ, so that
  /// it has no weight in an energy, what that site gives may be returned instead.
  DistanceSample sample(Vec3 p, TriangleId guess) const {
    if (guess.valid()) {
      const ClosestPoint found = field_->at_site(p, guess);
      return sample(p, found.squared_distance < enough_ * enough_ ? found
                                                                  : field_->closest_near(p, found, enough_));
    }
    return sample(p, field_->closest(p));
  }
  Vec3 normal(TriangleId t) const { return normals_[t.index()]; }
  double delta() const { return delta_; }
  const ToleranceField& field() const { return *field_; }
  const BorderGate* gate() const { return gate_; }
  /// Where many triangles of the input lie in one plane; null where it has none.
  const FlatParts* parts() const { return parts_ && parts_->size() > 0 ? &*parts_ : nullptr; }
  /// What keeps walls between their rooms; nothing does where there are two sides only.
  void set_rooms(const RoomSamples& rooms) { rooms_ = rooms; }
  const RoomSamples& rooms() const { return rooms_; }

 private:
  DistanceSample sample(Vec3 p, const ClosestPoint& c) const {
    const double d = c.distance();
    return {d, d > on_surface_ ? field_->gradient(p, c) : normal(c.triangle), c.triangle};
  }

  const ToleranceField* field_;
  const BorderGate* gate_;
  double delta_, on_surface_, enough_;
  RoomSamples rooms_;
  std::optional<FlatParts> parts_;
  std::vector<Vec3> normals_; ///< by site; zero for degenerate triangles
};

} // namespace isoscope
