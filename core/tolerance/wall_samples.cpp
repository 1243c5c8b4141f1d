// Steps from the middle of a piece into its triangle and from there to both sides.
#include "tolerance/wall_samples.h"

#include "base/parallel.h"

#include <array>

namespace isoscope {
namespace {

/// How far before the rim the pairs stand, and how far from the sheet, in units of δ'.
constexpr double before_rim = 0.05, height = 0.7;
/// In a fold of the sheet a point is nearer to it than it was set, but no nearer than this share of that.
constexpr double least_share = 0.5;

} // namespace

std::vector<WallSample> wall_samples(const ToleranceVolume& volume) {
  const OpenSides* sides = volume.open_sides();
  if (sides == nullptr) return {};
  const double level = height * volume.thresholds().boundary;
  const auto pieces = sides->rim().pieces();
  std::vector<std::array<WallSample, 2>> pairs(pieces.size());
  parallel_for(pieces.size(), 64, [&](std::size_t i) {
    const RimPiece& piece = pieces[i];
    if (!piece.open) return;
    const Vec3 foot = 0.5 * (piece.a + piece.b) - before_rim * volume.thresholds().boundary * piece.conormal;
    const Vec3 normal = normalized(cross(piece.b - piece.a, piece.conormal));
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec3 p = foot + (k == 0 ? level : -level) * normal;
      const ClosestPoint closest = volume.field().closest(p);
      if (closest.distance() >= least_share * level)
        pairs[i][k] = {p, static_cast<std::int8_t>(sides->side(p, closest))};
    }
  });
  std::vector<WallSample> samples;
  for (const auto& [one, other] : pairs)
    if (one.label != 0 && one.label == -other.label) samples.insert(samples.end(), {one, other});
  return samples;
}

} // namespace isoscope
