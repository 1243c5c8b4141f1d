// Cuts what lies near to other parts into pieces, and chooses samples for those that are outside.
#include "run/overlap_witnesses.h"

#include "base/halves.h"
#include "base/parallel.h"
#include "run/kept_points.h"

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

std::vector<Witness> overlap_witnesses(const ToleranceVolume& volume, const NearestSample& samples,
                                       const InputWalls& walls, double reach, std::span<const Witness> held,
                                       const RunControl& control) {
  std::vector<Witness> out;
  if (!volume.has_inner_walls()) return out;
  std::vector<std::vector<Vec3>> places(volume.index().size());
  parallel_until(places.size(), 16, control,
                 [&](std::size_t t) { places[t] = outer_places(volume, walls, TriangleId(t), reach); });
  for (const int label : {-1, +1}) {
    KeptPoints chosen(volume.index().bounds().lo, reach);
    for (const Witness& w : held)
      if (w.label == label) chosen.add(w.point);
    for (const std::vector<Vec3>& of_one : places)
      for (const Vec3 p : of_one) {
        if (control.cancelled()) return out;
        if (chosen.has_near(p)) continue;
        const SampleId nearest = samples.nearest_of(p, label, reach);
        if (!nearest.valid()) continue;
        const Vec3 sample = samples.positions()[nearest.index()];
        chosen.add(sample);
        out.push_back({sample, label, volume.field().distance(sample), true});
      }
  }
  return out;
}

} // namespace isoscope
