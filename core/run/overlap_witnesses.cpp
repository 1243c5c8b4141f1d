// Cuts what lies near to other parts into pieces, and chooses samples for those that are outside.
#include "run/overlap_witnesses.h"

#include "base/halves.h"
#include "base/parallel.h"
#include "run/held_samples.h"

#include <algorithm>

namespace isoscope {
namespace {

/// Pieces are no larger than this, in δ, from their middle.
constexpr double finest_piece = 0.75;

/// The middles of a triangle's pieces that are outside and near to another part.
std::vector<Vec3> outer_places(const ToleranceVolume& volume, const InputWalls& walls, TriangleId t,
                               double near) {
  std::vector<Vec3> places;
  const Vec3 normal = normalized(area_vector(volume.index().triangle(t)));
  if (normal == Vec3{}) return places;
  std::vector<Triangle3> open{volume.index().triangle(t)};
  while (!open.empty()) {
    const Triangle3 piece = open.back();
    open.pop_back();
    if (!walls.near_another_part(t, piece, near)) continue;
    const Vec3 middle = centroid(piece);
    const double radius =
        std::max({distance(middle, piece[0]), distance(middle, piece[1]), distance(middle, piece[2])});
    if (radius > finest_piece * volume.thresholds().delta) {
      for (const Triangle3& half : halves(piece)) open.push_back(half);
    } else if (walls.judge(t, middle, normal).kind == Wall::outer) {
      places.push_back(middle);
    }
  }
  return places;
}

} // namespace

void hold_overlaps(const ToleranceVolume& volume, const NearestSample& samples, const InputWalls& walls,
                   double reach, std::vector<Witness>& held, const RunControl& control) {
  if (!volume.has_inner_walls()) return;
  std::vector<std::vector<Vec3>> of_triangle(volume.index().size());
  parallel_until(of_triangle.size(), 16, control,
                 [&](std::size_t t) { of_triangle[t] = outer_places(volume, walls, TriangleId(t), reach); });
  std::vector<Vec3> places;
  for (const std::vector<Vec3>& of_one : of_triangle)
    places.insert(places.end(), of_one.begin(), of_one.end());
  for (const int label : {-1, +1}) hold_samples(volume, samples, label, places, reach, held, control);
}

} // namespace isoscope
