// Faces between a solid cube and an empty one.
#include "run/voxel_soup.h"

#include <array>
#include <map>

namespace isoscope::test {

TriangleSoup voxel_surface(std::array<int, 3> size, const std::function<bool(int, int, int)>& solid) {
  TriangleSoup soup;
  std::map<std::array<int, 3>, std::uint32_t> ids;
  const auto vertex = [&](std::array<int, 3> p) {
    const auto [it, added] = ids.try_emplace(p, static_cast<std::uint32_t>(soup.points.size()));
    if (added)
      soup.points.push_back(
          {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    return it->second;
  };
  const auto inside = [&](std::array<int, 3> c) {
    for (std::size_t a = 0; a < 3; ++a)
      if (c[a] < 0 || c[a] >= size[a]) return false;
    return solid(c[0], c[1], c[2]);
  };
  const auto add_face = [&](std::array<int, 3> cube, std::size_t axis, int side) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<std::uint32_t, 4> corner{};
    constexpr std::array<std::array<int, 2>, 4> ring{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<int, 3> p = cube;
      p[axis] += side;
      p[u] += ring[side == 1 ? k : 3 - k][0];
      p[v] += ring[side == 1 ? k : 3 - k][1];
      corner[k] = vertex(p);
    }
    soup.triangles.push_back({corner[0], corner[1], corner[2]});
    soup.triangles.push_back({corner[0], corner[2], corner[3]});
  };
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) {
        const std::array<int, 3> cube{x, y, z};
        if (!inside(cube)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (const int side : {0, 1}) {
            std::array<int, 3> next = cube;
            next[axis] += side == 1 ? 1 : -1;
            if (!inside(next)) add_face(cube, axis, side);
          }
      }
  return soup;
}

} // namespace isoscope::test
