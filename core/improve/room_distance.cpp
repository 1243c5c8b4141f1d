// Asks for the nearest sample of one label.
#include "improve/room_distance.h"

#include <algorithm>

namespace isoscope {
namespace {

constexpr double enough = 2.5, usual_reach = 4; ///< in δ
/// Farther than this share of the reach all is alike.
constexpr double farthest = 2;

} // namespace

RoomSamples::Distance RoomSamples::at(Vec3 p, std::int8_t label) const {
  if (!samples->has(label)) return {};
  const SampleId nearest = samples->nearest_of(p, label, farthest * reach);
  const double scale = delta / (reach - enough);
  if (!nearest.valid()) return {scale * (farthest * reach - enough), {}};
  const Vec3 away = p - samples->positions()[nearest.index()];
  const double d = length(away);
  if (d <= enough) return {};
  return {scale * (d - enough), (scale / d) * away};
}

RoomSamples room_samples(const TriangleMesh& surface, const NearestSample& samples, double delta) {
  double reach = usual_reach * delta;
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const auto& v = surface.triangles[f];
    const Triangle3 t{surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]};
    for (const std::int8_t label : {surface.labels[f].front, surface.labels[f].back}) {
      if (!samples.has(label)) continue;
      for (const Vec3 p : {t[0], t[1], t[2], centroid(t)}) {
        const SampleId nearest = samples.nearest_of(p, label);
        reach = std::max(reach, distance(p, samples.positions()[nearest.index()]));
      }
    }
  }
  return {&samples, enough * delta, 1.01 * reach, delta};
}

} // namespace isoscope
