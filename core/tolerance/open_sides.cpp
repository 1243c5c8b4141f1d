// Signs by pseudonormals, and what is over the rim.
#include "tolerance/open_sides.h"

#include <algorithm>

namespace isoscope {
namespace {

/// Pieces up to the first size, in units of δ, are over the rim where their corners and their centre are; up
/// to the second where their centre is.
constexpr double judged_by_corners = 0.25, judged_by_center = 0.02;

std::vector<std::uint8_t> by_triangle(const std::vector<std::uint32_t>& component,
                                      const std::vector<std::uint8_t>& open) {
  std::vector<std::uint8_t> wanted(component.size());
  for (std::size_t t = 0; t < component.size(); ++t) wanted[t] = open[component[t]];
  return wanted;
}

PseudoNormals normals_of(const ClosestPointIndex& index, std::span<const std::int8_t> turns) {
  const WeldedMesh mesh = weld(index);
  return PseudoNormals(mesh.points, mesh.triangles, turns);
}

} // namespace

OpenSides::OpenSides(std::shared_ptr<const ClosestPointIndex> index, std::vector<std::uint32_t> component,
                     std::vector<std::uint8_t> open, std::span<const std::int8_t> turns, double boundary,
                     const RunControl& control)
    : index_(std::move(index)), component_(std::move(component)), open_(std::move(open)),
      normals_(normals_of(*index_, turns)), rim_(*index_, by_triangle(component_, open_), boundary, control) {
}

bool OpenSides::all_open() const {
  return std::all_of(open_.begin(), open_.end(), [](std::uint8_t open) { return open != 0; });
}

int OpenSides::side(Vec3 p, const ClosestPoint& closest) const {
  if (rim_.is_nearest(p, closest.distance())) return 0;
  const Vec3 n = normals_.at(closest.triangle, index_->triangle(closest.triangle), closest.point);
  const double rise = dot(n, p - closest.point);
  return rise > 0 ? +1 : rise < 0 ? -1 : 0;
}

PieceVerdict OpenSides::judge_outside(const Triangle3& piece, Vec3 center, const ClosestPoint& closest,
                                      double radius, double delta) const {
  if (!is_open(closest.triangle)) return PieceVerdict::violates;
  const double d = closest.distance(), far = reach * delta;
  if (d > far) return d - radius > far ? PieceVerdict::passes : PieceVerdict::divide;
  if (!rim_.is_nearest(center, d)) return PieceVerdict::violates;
  if (radius <= judged_by_center * delta) return PieceVerdict::passes;
  if (radius > judged_by_corners * delta) return PieceVerdict::divide;
  const bool all = std::all_of(piece.begin(), piece.end(), [&](Vec3 p) {
    return rim_.is_nearest(p, index_->closest_near(p, closest.triangle).distance());
  });
  return all ? PieceVerdict::passes : PieceVerdict::divide;
}

std::size_t OpenSides::memory_bytes() const {
  return component_.capacity() * sizeof(std::uint32_t) + open_.capacity() + normals_.memory_bytes() +
         rim_.memory_bytes();
}

} // namespace isoscope
