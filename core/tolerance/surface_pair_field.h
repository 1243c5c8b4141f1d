// Ω given by two closed surfaces: what lies between them (§1.1).
#pragma once

#include "tolerance/field.h"
#include "tolerance/pseudo_normals.h"
#include "tolerance/surface_pair.h"

namespace isoscope {

/// φ = max(0, δ + s d), where d is the distance to both surfaces, s is -1 between them and +1 elsewhere, and
/// δ is half the least distance between the two: so Ω = {φ <= δ} is all that lies between them. Sites are the
/// triangles of the walls.
class SurfacePairField final : public ToleranceField {
 public:
  /// Fails with cancelled.
  static Result<std::shared_ptr<const SurfacePairField>> make(SurfacePair pair, const RunControl& control);

  double delta() const { return delta_; }
  /// A point of the outer surface where the two come nearest to each other, as far as triangles are small.
  Vec3 narrowest() const { return narrowest_; }

  FieldKind kind() const override { return FieldKind::surfaces; }
  std::size_t size() const override { return walls().size(); }
  const Box3& bounds() const override { return walls().bounds(); }
  double area() const override { return 0.5 * walls().area(); }
  std::size_t memory_bytes() const override;
  ClosestPoint closest(Vec3 p) const override { return answer(p, walls().closest(p)); }
  ClosestPoint closest_near(Vec3 p, TriangleId guess) const override {
    return answer(p, walls().closest_near(p, guess));
  }
  void find_neighborhood(Vec3 center, double radius, TriangleNeighborhood& near) const override;
  ClosestPoint closest_near(Vec3 p, TriangleId guess, const TriangleNeighborhood& near,
                            double enough = 0) const override {
    static_cast<void>(enough); // the nearest wall tells the side: no other one will do
    return answer(p, walls().closest_near(p, guess, near));
  }
  Vec3 place_of(TriangleId site) const override { return centroid(walls().triangle(site)); }
  std::optional<Range> range_in_cube(Vec3 center, double half_side) const override;
  std::optional<bool> meets_boundary(const Triangle3& facet) const override;
  std::optional<bool> holds_exactly(Vec3 p) const override;
  int side(Vec3 p) const override { return wall_of(walls().closest(p).triangle) == 0 ? +1 : -1; }
  std::vector<Vec3> region_seeds() const override { return pair_.seeds; }
  VolumeComponents components(double r, const RunControl& control) const override;

 private:
  explicit SurfacePairField(SurfacePair pair);
  const ClosestPointIndex& walls() const { return *pair_.index; }
  std::size_t wall_of(TriangleId t) const { return t.index() < pair_.outer ? 0 : 1; }
  Vec3 normal(TriangleId t) const;
  bool is_outside(Vec3 p, const ClosestPoint& nearest) const;
  ClosestPoint answer(Vec3 p, const ClosestPoint& nearest) const;

  SurfacePair pair_;
  double delta_ = 0;
  Vec3 narrowest_;
  PseudoNormals normals_;
};

} // namespace isoscope
