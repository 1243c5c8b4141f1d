// Steps from the middle of a piece into its triangle and from there to both sides.
#include "tolerance/wall_samples.h"

#include "base/parallel.h"

#include <array>

namespace isoscope {
namespace {

/// How far before the rim the pairs stand, and how far from the sheet, in units of δ'.
constexpr double before_rim = 0.05, highest = 0.7;
/// In a fold of the sheet a point is nearer to it than it was set, but no nearer than this share of that.
constexpr double least_share = 0.5;
/// Nearer to the input than this share of its height it is between walls.
constexpr double own_share = 0.95;
/// Between walls that are nearer to each other the pairs stand lower, by halves so many times.
constexpr int most_pair_halvings = 3;

using Pair = std::array<WallSample, 2>;

/// One point on each side of the sheet at a height, where they are on different sides.
Pair pair_at(const ToleranceVolume& volume, Vec3 foot, Vec3 normal, double level) {
  Pair pair;
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3 p = foot + (k == 0 ? level : -level) * normal;
    const ClosestPoint closest = volume.field().closest(p);
    if (closest.distance() < least_share * level) return {};
    pair[k] = {p, static_cast<std::int8_t>(volume.open_sides()->side(p, closest)),
               closest.distance() < own_share * level};
  }
  return pair[0].label != 0 && pair[0].label == -pair[1].label ? pair : Pair();
}

} // namespace

std::vector<WallSample> wall_samples(const ToleranceVolume& volume) {
  const OpenSides* sides = volume.open_sides();
  if (sides == nullptr) return {};
  const double level = highest * volume.thresholds().boundary;
  const auto pieces = sides->rim().pieces();
  std::vector<Pair> pairs(pieces.size());
  parallel_for(pieces.size(), 64, [&](std::size_t i) {
    const RimPiece& piece = pieces[i];
    if (!piece.open) return;
    const Vec3 foot = 0.5 * (piece.a + piece.b) - before_rim * volume.thresholds().boundary * piece.conormal;
    const Vec3 normal = normalized(cross(piece.b - piece.a, piece.conormal));
    double height = level;
    for (int k = 0; k <= most_pair_halvings && pairs[i][0].label == 0; ++k, height *= 0.5)
      pairs[i] = pair_at(volume, foot, normal, height);
  });
  std::vector<WallSample> samples;
  for (const auto& [one, other] : pairs)
    if (one.label != 0) samples.insert(samples.end(), {one, other});
  return samples;
}

} // namespace isoscope
