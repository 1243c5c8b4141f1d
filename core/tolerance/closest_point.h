// Exact closest points on a triangle soup: the distance function d behind everything.
#pragma once

#include "base/geometry.h"
#include "base/ids.h"
#include "base/run_control.h"
#include "input/triangle_soup.h"
#include "tolerance/box_hierarchy.h"
#include "tolerance/field.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace isoscope {

/// Closest point on triangle abc to p, in double precision. Degenerate triangles count as segments or points.
Vec3 closest_point_on_triangle(Vec3 p, const Triangle3& t);

/// Whether the distance between two triangles is at most r.
bool triangles_within(const Triangle3& a, const Triangle3& b, double r);
/// The distance of two triangles that do not meet.
double disjoint_triangle_distance(const Triangle3& a, const Triangle3& b);

/// A bounding volume hierarchy over the triangles of a soup. Immutable after construction; all queries are
/// thread-safe.
class ClosestPointIndex final : public ToleranceField {
 public:
  /// Degenerate triangles are kept as the segments or points they are. A soup without triangles makes an
  /// index that finds nothing: every distance is infinite.
  explicit ClosestPointIndex(const TriangleSoup& soup);
  /// The same; once the control is cancelled, an index that finds nothing.
  ClosestPointIndex(const TriangleSoup& soup, const RunControl& control);
  /// The same of triangles as they are, which are needed no more after that.
  ClosestPointIndex(std::span<const Triangle3> triangles, const RunControl& control);

  /// The closest point within `radius` of p (ties: smallest triangle id of equal distance is not promised,
  /// but the result depends on p and the soup only).
  ClosestPoint closest_within(Vec3 p, double radius) const override;
  ClosestPoint closest(Vec3 p) const override {
    return closest_within(p, std::numeric_limits<double>::infinity());
  }
  /// The same, starting from a guess that is likely close: a faster query, the same distance.
  ClosestPoint closest_near(Vec3 p, TriangleId guess) const override;
  /// The same, starting from the closest point on some triangle. Once something nearer than `enough` is found
  /// it may be returned.
  ClosestPoint closest_near(Vec3 p, const ClosestPoint& found, double enough) const override {
    return search(p, found, enough * enough);
  }

  /// Fills `near` with the triangles within `radius` of `center`; leaves it unusable, which makes its queries
  /// slower but not wrong, where they are many.
  void find_neighborhood(Vec3 center, double radius, TriangleNeighborhood& near) const override;
  /// The same as closest_near for any p; fast where d(p) + |p - near.center| <= near.radius. Where d(p) is
  /// below `enough`, any point nearer than that may be returned.
  ClosestPoint closest_near(Vec3 p, TriangleId guess, const TriangleNeighborhood& near,
                            double enough = 0) const override;

  /// Whether p is enclosed by an odd number of layers, by majority over several rays. Meaningful for closed
  /// input only.
  bool inside_by_parity(Vec3 p) const;
  /// How often the input winds around p, as most of several rays tell: the triangles a ray leaves through
  /// count +1, those it enters through -1, each times its entry of `turns` (by id; empty: 1). Meaningful
  /// where the triangles cancel along every edge.
  int winding_number(Vec3 p, std::span<const std::int8_t> turns) const;
  /// Parameters t in (0, 1) at which the open segment a + t (b - a) crosses the input, ascending.
  std::vector<double> crossings(Vec3 a, Vec3 b) const;
  /// Ids of the triangles whose bounding boxes meet `box`, ascending.
  std::vector<TriangleId> triangles_in(const Box3& box) const;

  /// The same from anything found before, of several triangles at the same distance that with the smallest
  /// id: the answer depends on p alone.
  ClosestPoint nearest_from(Vec3 p, const ClosestPoint& found_before) const;

  const Triangle3& triangle(TriangleId id) const { return triangles_[slots_[id.index()]]; }
  /// Slots are the triangles' places in memory, where neighbours are near to each other.
  std::uint32_t slot_of(TriangleId id) const { return slots_[id.index()]; }
  TriangleId id_at(std::uint32_t slot) const { return TriangleId(boxes_.ids[slot]); }
  const Triangle3& triangle_at(std::uint32_t slot) const { return triangles_[slot]; }
  /// Whether all triangles within `radius` of `center` lie in the plane of one of them up to `slack`; false
  /// where that one has none.
  bool coplanar_within(Vec3 center, double radius, TriangleId site, double slack) const;
  /// Slots of all triangles within `reach` of a box, and some others.
  std::vector<std::uint32_t> slots_within(const Box3& box, double reach) const;
  FieldKind kind() const override { return FieldKind::triangles; }
  std::size_t size() const override { return triangles_.size(); }
  const Box3& bounds() const override { return boxes_.bounds; }
  double area() const override { return area_; }
  std::size_t memory_bytes() const override;
  ClosestPoint at_site(Vec3 p, TriangleId site) const override {
    const Vec3 c = closest_point_on_triangle(p, triangle(site));
    return {c, squared_length(c - p), site};
  }
  double convex_bound(const Triangle3& facet, TriangleId site) const override;
  Vec3 place_of(TriangleId site) const override { return centroid(triangle(site)); }
  bool is_distance() const override { return true; }
  VolumeComponents components(double r, const RunControl& control) const override;
  const ClosestPointIndex* surface() const override { return this; }

 private:
  template <class TriangleAt>
  void fill(std::size_t count, const TriangleAt& given, const RunControl* control);
  /// `replaces(squared distance, slot, best)`: whether a triangle takes the place of the best so far.
  template <class Replaces>
  ClosestPoint search(Vec3 p, ClosestPoint best, double squared_enough, const Replaces& replaces) const;
  ClosestPoint search(Vec3 p, ClosestPoint best, double squared_enough = 0) const;
  template <class MeetsBox, class AtSlot> void visit(const MeetsBox& meets_box, const AtSlot& at_slot) const;

  /// The plane through a triangle: normal · x = offset. The normal is zero where the triangle has none.
  struct Plane {
    Vec3 normal;
    double offset;
  };
  std::vector<Triangle3> triangles_; ///< in leaf order
  std::vector<Plane> planes_;        ///< by slot
  std::vector<std::uint32_t> slots_; ///< triangle id -> slot
  BoxHierarchy boxes_;
  double area_ = 0;
  double largest_coordinate_ = 0;
};

} // namespace isoscope
