// Unit cubes that share walls, as a labelled mesh.
#pragma once

#include "input/triangle_soup.h"

#include <map>

namespace isoscope::testing {

/// So many cubes along each axis, labelled -1, -2, … with x running first; each wall of n x n squares, each
/// vertex once.
inline TriangleMesh room_mesh(std::array<int, 3> cubes, int n) {
  TriangleMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto vertex = [&](std::array<int, 3> at) {
    const auto [found, fresh] = numbers.emplace(at, static_cast<std::uint32_t>(mesh.points.size()));
    if (fresh) mesh.points.push_back({double(at[0]) / n, double(at[1]) / n, double(at[2]) / n});
    return found->second;
  };
  const auto label = [&](std::array<int, 3> cell) {
    for (std::size_t k = 0; k < 3; ++k)
      if (cell[k] < 0 || cell[k] >= cubes[k]) return std::int8_t{1};
    return static_cast<std::int8_t>(-1 - cell[0] - cubes[0] * (cell[1] + cubes[1] * cell[2]));
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    for (int a = 0; a <= cubes[k]; ++a)
      for (int b = 0; b < cubes[u] * n; ++b)
        for (int c = 0; c < cubes[v] * n; ++c) {
          std::array<int, 3> cell{};
          cell[k] = a, cell[u] = b / n, cell[v] = c / n;
          const std::int8_t above = label(cell);
          --cell[k];
          const std::int8_t below = label(cell);
          if (above == below) continue;
          std::array<std::uint32_t, 4> corner{};
          for (int i = 0; i < 4; ++i) {
            std::array<int, 3> at{};
            at[k] = a * n, at[u] = b + (i == 1 || i == 2), at[v] = c + (i > 1);
            corner[static_cast<std::size_t>(i)] = vertex(at);
          }
          if (above < below) std::swap(corner[1], corner[3]);
          for (const auto& [x, y] : {std::array<std::size_t, 2>{1, 2}, {2, 3}}) {
            mesh.triangles.push_back({corner[0], corner[x], corner[y]});
            mesh.labels.push_back({std::max(above, below), std::min(above, below)});
          }
        }
  }
  return mesh;
}

} // namespace isoscope::testing
