// The field around Ω on a sparse grid: bricks of samples, from which the viewer renders Ω.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/field.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace isoscope {

/// φ / δ at the corners of the cells of a lattice, where that may be at most `level`. The lattice is divided
/// into places of `cells`³ cells; a place that Ω comes near to has a brick, which holds the samples at all
/// corners of its cells: neighbours share those of their common face.
struct DistanceGrid {
  static constexpr int cells = 7, samples = cells + 1;
  static constexpr std::size_t brick_size = std::size_t{samples} * samples * samples;
  static constexpr std::int16_t most = 32767;
  static constexpr std::int32_t outer = -1, inner = -2; ///< places without brick, by side
  /// More than the texture of them has room for.
  static constexpr std::size_t most_bricks = 530'000;

  Box3 box;                           ///< of all places
  double delta = 0;                   ///< scene units
  double voxel = 1;                   ///< side of a cell, scene units
  float level = 1;                    ///< up to which Ω can be drawn
  float reach = 2;                    ///< that φ / δ exceeds wherever there is no brick; beyond `level`
  float clamp = 4;                    ///< that no sample exceeds
  std::array<int, 3> places{0, 0, 0}; ///< x fastest in `index`
  std::vector<std::int32_t> index;    ///< by place: its brick, or `outer` or `inner`
  std::vector<std::array<int, 3>> at; ///< by brick: its place
  /// By brick and sample, x fastest: most · φ / (clamp δ), at least 1, negative on the inner side.
  std::vector<std::int16_t> values;
  bool has_sides = false; ///< whether signs and empty places tell sides; until then all is outer
  bool coarsened = false; ///< memory allowed no voxels as small as were asked for
  /// What a sample takes in a texture. Where it is one, φ is rounded to reach/127 there, as finer steps would
  /// have taken larger voxels.
  std::size_t sample_bytes = 2;
  std::size_t side_bytes = 0; ///< that its side takes besides, where it has a texture of its own

  bool empty() const { return at.empty(); }
  std::size_t bricks() const { return at.size(); }
  std::span<const std::int16_t> brick(std::size_t i) const {
    return std::span(values).subspan(i * brick_size, brick_size);
  }
  std::size_t place(std::array<int, 3> p) const {
    return (static_cast<std::size_t>(p[2]) * static_cast<std::size_t>(places[1]) +
            static_cast<std::size_t>(p[1])) *
               static_cast<std::size_t>(places[0]) +
           static_cast<std::size_t>(p[0]);
  }
  static std::size_t sample(int x, int y, int z) {
    return static_cast<std::size_t>((z * samples + y) * samples + x);
  }
  Vec3 corner(std::array<int, 3> p) const {
    return box.lo + cells * voxel *
                        Vec3{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  }
  /// ±φ/δ at a point, linear between samples; ±reach where there are none. Beyond the box +reach.
  double signed_value(Vec3 p) const;
  /// The same of φ/δ.
  double value(Vec3 p) const;
  /// What it takes as a texture.
  std::size_t texture_bytes() const {
    return values.size() * (sample_bytes + side_bytes) + index.size() * sizeof(std::uint32_t);
  }
};

/// How finely Ω is wanted.
struct GridWish {
  double delta = 0;
  double level = 1;                                          ///< the largest at which Ω may be drawn
  double voxel = 0;                                          ///< side of a cell, scene units
  double coarsest = std::numeric_limits<double>::infinity(); ///< voxels that are no fault
  std::size_t most_bytes = std::size_t{256} << 20;           ///< of textures
  std::size_t side_bytes = 0;                                ///< of a sample, beside its value
  Box3 within; ///< the part of Ω that is wanted; an empty one: all of it
};

/// Exact at every sample, up to clamp δ / 32767. There are samples at the corners of every cell in which φ is
/// somewhere at most level δ, and as far around as gradients there look. Voxels are larger than asked for
/// where memory demands it, but first samples take one byte instead of two.
Result<DistanceGrid> make_distance_grid(const ToleranceField& field, const GridWish& wish,
                                        const RunControl& control);

} // namespace isoscope
