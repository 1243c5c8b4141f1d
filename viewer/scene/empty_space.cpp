// Chebyshev distances between places.
#include "scene/empty_space.h"

#include "base/parallel.h"
#include "scene/brick_atlas.h"

#include <algorithm>
#include <cstdlib>

namespace isoscope {
namespace {

constexpr float aside = 0.1f; ///< of the level, in δ

} // namespace

std::vector<float> least_in_bricks(const DistanceGrid& grid) {
  std::vector<float> least(grid.bricks());
  const float unit = grid.clamp / DistanceGrid::most;
  parallel_for(least.size(), 64, [&](std::size_t i) {
    std::int16_t positive = DistanceGrid::most, negative = DistanceGrid::most;
    for (const std::int16_t v : grid.brick(i))
      (v > 0 ? positive : negative) =
          std::min<std::int16_t>(v > 0 ? positive : negative, static_cast<std::int16_t>(std::abs(v)));
    const bool both = positive < DistanceGrid::most && negative < DistanceGrid::most;
    least[i] = both ? -1.0f : unit * static_cast<float>(std::min(positive, negative));
  });
  return least;
}

std::vector<std::uint32_t> place_entries(const DistanceGrid& grid, const std::vector<float>& least,
                                         float level) {
  constexpr std::uint32_t far_away = 255;
  const std::array<int, 3>& size = grid.places;
  const BrickAtlas atlas(grid.bricks());
  std::vector<std::uint32_t> entries(grid.index.size());
  std::vector<std::uint8_t> steps(entries.size());
  parallel_for(entries.size(), 1u << 16, [&](std::size_t i) {
    const std::int32_t brick = grid.index[i];
    const bool has = brick >= 0;
    // A ray that leaves an empty place goes on a little beyond: it must not be in Ω there.
    const bool full = has && least[static_cast<std::size_t>(brick)] <= level + aside;
    entries[i] = atlas.packed(has                            ? static_cast<std::size_t>(brick)
                              : brick == DistanceGrid::inner ? atlas.inner()
                                                             : atlas.outer());
    steps[i] = static_cast<std::uint8_t>(full ? 0 : far_away);
  });
  // Chebyshev distance to the nearest full place: along one axis after the other.
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(size[0]),
                                          static_cast<std::size_t>(size[0]) *
                                              static_cast<std::size_t>(size[1])};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto length = static_cast<std::size_t>(size[axis]);
    const std::size_t across = (axis + 1) % 3, along = (axis + 2) % 3;
    const auto rows = static_cast<std::size_t>(size[across]) * static_cast<std::size_t>(size[along]);
    parallel_for(rows, 64, [&](std::size_t row) {
      const std::size_t first = row % static_cast<std::size_t>(size[across]) * stride[across] +
                                row / static_cast<std::size_t>(size[across]) * stride[along];
      if (axis == 0) {
        // In one dimension the distance is what two sweeps find.
        for (std::size_t i = 1; i < length; ++i) {
          std::uint8_t& here = steps[first + i];
          here = std::min<std::uint8_t>(
              here, static_cast<std::uint8_t>(std::min<int>(steps[first + i - 1] + 1, far_away)));
        }
        for (std::size_t i = length - 1; i-- > 0;) {
          std::uint8_t& here = steps[first + i];
          here = std::min<std::uint8_t>(
              here, static_cast<std::uint8_t>(std::min<int>(steps[first + i + 1] + 1, far_away)));
        }
        return;
      }
      // The least over all places of the row of max(what is there, how far that is): growing what is looked
      // at until nothing farther can be less.
      std::vector<std::uint8_t> old(length);
      for (std::size_t i = 0; i < length; ++i) old[i] = steps[first + i * stride[axis]];
      for (std::size_t i = 0; i < length; ++i) {
        std::size_t best = old[i];
        for (std::size_t away = 1; away < best; ++away) {
          if (i >= away) best = std::min(best, std::max<std::size_t>(old[i - away], away));
          if (i + away < length) best = std::min(best, std::max<std::size_t>(old[i + away], away));
        }
        steps[first + i * stride[axis]] = static_cast<std::uint8_t>(best);
      }
    });
  }
  parallel_for(entries.size(), 1u << 16,
               [&](std::size_t i) { entries[i] |= static_cast<std::uint32_t>(steps[i]) << brick_bits; });
  return entries;
}

} // namespace isoscope
