// Closes holes of Z with triangles between the vertices of their borders, once Z has left T (§4.1).
#pragma once

#include "mesh/complex.h"
#include "simplify/hole_filling.h"
#include "tolerance/tolerance_volume.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace isoscope {

struct FreeFilling {
  Delta delta;                      ///< the facets that fill, of all holes that could be filled
  std::vector<std::uint32_t> loops; ///< of the rim that they fill, ascending
  struct Refusal {
    std::uint32_t loop;
    std::string why; ///< ends a sentence: "it would run through the surface"
  };
  std::vector<Refusal> refused;
};

/// Fills each hole that is wanted with the triangulation of its border that has the least area, without
/// further vertices, unless that meets Z or what fills another hole. Nothing of use once stop(), which is
/// asked all the time, became true.
FreeFilling fill_free_holes(const Complex& complex, const ToleranceVolume& volume, const HoleChoice& choice,
                            const std::function<bool()>& stop);

/// The triangulation of a closed polygon, by indices into it, that has the least area, of several the one
/// with the shorter edges; none where every one has an edge that `forbidden` names (by two indices) or there
/// are too many corners.
std::vector<std::array<std::uint32_t, 3>>
least_triangulation(std::span<const Vec3> polygon,
                    const std::function<bool(std::size_t, std::size_t)>& forbidden);

} // namespace isoscope
