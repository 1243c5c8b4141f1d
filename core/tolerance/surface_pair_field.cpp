// Distances to the walls, with signs by the normal of whatever is nearest: a face, an edge or a vertex.
#include "tolerance/surface_pair_field.h"

#include "tolerance/exact_position.h"
#include "tolerance/index_building.h"
#include "tolerance/separation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isoscope {
namespace {

/// The sine under which a direction lies in a plane as far as anybody can tell: then rays decide.
constexpr double least_sine = 1e-7;

TriangleSoup part(const TriangleSoup& walls, std::size_t begin, std::size_t end) {
  TriangleSoup soup;
  soup.points = walls.points;
  soup.triangles.assign(walls.triangles.begin() + static_cast<std::ptrdiff_t>(begin),
                        walls.triangles.begin() + static_cast<std::ptrdiff_t>(end));
  return soup;
}

} // namespace

SurfacePairField::SurfacePairField(SurfacePair pair) : pair_(std::move(pair)) {}

Result<std::shared_ptr<const SurfacePairField>> SurfacePairField::make(SurfacePair pair,
                                                                       const RunControl& control) {
  std::shared_ptr<SurfacePairField> field(new SurfacePairField(std::move(pair)));
  const TriangleSoup& walls = field->pair_.walls;
  const auto outer = build_index(part(walls, 0, field->pair_.outer), control);
  const auto inner = build_index(part(walls, field->pair_.outer, walls.triangles.size()), control);
  const Separation separation = find_separation(*outer, *inner, control);
  if (control.cancelled())
    return Error{ErrorCode::cancelled, "Stopped while the surfaces were compared.", ""};
  field->delta_ = 0.5 * separation.distance;
  field->narrowest_ = centroid(outer->triangle(separation.triangle));
  field->normals_ = PseudoNormals(walls.points, walls.triangles);
  return std::shared_ptr<const SurfacePairField>(std::move(field));
}

Vec3 SurfacePairField::normal(TriangleId t) const {
  const Triangle3& c = walls().triangle(t);
  return normalized(cross(c[1] - c[0], c[2] - c[0]));
}

bool SurfacePairField::is_outside(Vec3 p, const ClosestPoint& nearest) const {
  const Vec3 q = nearest.point;
  const Vec3 n = normals_.at(nearest.triangle, walls().triangle(nearest.triangle), q);
  const double rise = dot(n, p - q);
  if (std::abs(rise) <= least_sine * nearest.distance() && nearest.squared_distance > 0)
    return !walls().inside_by_parity(p); // the volume is inside an odd number of walls
  return rise > 0;
}

ClosestPoint SurfacePairField::answer(Vec3 p, const ClosestPoint& nearest) const {
  if (!nearest.triangle.valid()) return nearest;
  const double d = nearest.distance();
  const bool outside = is_outside(p, nearest);
  const double phi = outside ? delta_ + d : std::max(0.0, delta_ - d);
  if (phi == 0) return {p, 0, nearest.triangle};
  const Vec3 up = d > 0 ? ((outside ? 1 : -1) / d) * (p - nearest.point) : normal(nearest.triangle);
  return {p - phi * up, phi * phi, nearest.triangle};
}

void SurfacePairField::find_neighborhood(Vec3 center, double radius, TriangleNeighborhood& near) const {
  // φ grows by no more than d does, so what φ gains up to the radius d may gain.
  const ClosestPoint nearest = walls().closest(center);
  const double phi = answer(center, nearest).distance();
  walls().find_neighborhood(center, nearest.distance() + std::max(0.0, radius - phi), near);
}

std::optional<ToleranceField::Range> SurfacePairField::range_in_cube(Vec3 center, double half_side) const {
  const ClosestPoint nearest = walls().closest(center);
  const double reach = std::sqrt(3.0) * half_side * (1 + 1e-7), d = nearest.distance();
  const double unclamped = delta_ + (is_outside(center, nearest) ? d : -d);
  return Range{std::max(0.0, unclamped - reach), std::max(0.0, unclamped + reach)};
}

std::optional<bool> SurfacePairField::meets_boundary(const Triangle3& facet) const {
  const Vec3 center = centroid(facet);
  Box3 box;
  double radius2 = 0;
  for (const Vec3 p : facet) {
    box.add(p);
    radius2 = std::max(radius2, squared_length(p - center));
  }
  // Most facets are far from all walls: a distance is cheaper than a list.
  if (walls().distance(center) > std::sqrt(radius2) * (1 + 1e-9) + 1e-12 * walls().bounds().longest_edge())
    return false;
  const std::vector<TriangleId> near = walls().triangles_in(box);
  return std::any_of(near.begin(), near.end(),
                     [&](TriangleId t) { return triangles_meet(facet, walls().triangle(t)); });
}

std::optional<bool> SurfacePairField::holds_exactly(Vec3 p) const {
  const auto crossed = crossed_on_the_way_out(p, walls());
  return crossed && crossed->size() % 2 != 0; // a point on a wall is on none of its sides
}

VolumeComponents SurfacePairField::components(double r, const RunControl& control) const {
  static_cast<void>(r); // what is narrower than twice δ - r keeps together: its walls are those of one part
  static_cast<void>(control);
  return {pair_.component, pair_.components};
}

std::size_t SurfacePairField::memory_bytes() const {
  return walls().memory_bytes() + pair_.walls.points.capacity() * sizeof(Vec3) +
         pair_.walls.triangles.capacity() * sizeof(IndexTriangle) + normals_.memory_bytes() +
         pair_.component.capacity() * sizeof(std::uint32_t);
}

} // namespace isoscope
