// Looks at every voxel's neighbour behind it along each axis.
#include "input/label_walls.h"

#include <array>
#include <unordered_map>

namespace isoscope {
namespace {

using Place = std::array<std::size_t, 3>;

/// Corners of voxels, each made once.
class Corners {
 public:
  Corners(const ScalarGrid& grid, TriangleSoup& soup) : grid_(grid), soup_(soup) {}
  std::uint32_t operator()(const Place& p) {
    const std::size_t key = (p[2] * (grid_.size[1] + 1) + p[1]) * (grid_.size[0] + 1) + p[0];
    const auto [at, fresh] = numbers_.emplace(key, static_cast<std::uint32_t>(soup_.points.size()));
    if (fresh) soup_.points.push_back(grid_.point(p[0], p[1], p[2]) - 0.5 * grid_.spacing);
    return at->second;
  }

 private:
  const ScalarGrid& grid_;
  TriangleSoup& soup_;
  std::unordered_map<std::size_t, std::uint32_t> numbers_; ///< looked up only, never iterated
};

} // namespace

Result<TriangleSoup> walls_between_labels(const ScalarGrid& labels) {
  TriangleSoup soup;
  soup.name = labels.name;
  Corners corner(labels, soup);
  const auto at = [&](const Place& p) {
    const bool inside = p[0] < labels.size[0] && p[1] < labels.size[1] && p[2] < labels.size[2];
    return inside ? labels.at(p[0], p[1], p[2]) : 0.0F; // unsigned: what lies before 0 is not inside either
  };
  for (std::size_t z = 0; z <= labels.size[2]; ++z)
    for (std::size_t y = 0; y <= labels.size[1]; ++y)
      for (std::size_t x = 0; x <= labels.size[0]; ++x)
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Place here{x, y, z};
          Place before = here;
          --before[axis];
          if (at(before) == at(here)) continue;
          Place u = here, v = here;
          ++u[(axis + 1) % 3];
          ++v[(axis + 2) % 3];
          Place across = u;
          ++across[(axis + 2) % 3];
          const std::uint32_t a = corner(here), b = corner(u), c = corner(across), d = corner(v);
          soup.triangles.push_back({a, b, c});
          soup.triangles.push_back({a, c, d});
        }
  if (soup.triangles.empty())
    return Error{ErrorCode::bad_input, "Every voxel has the label 0, which is the outside.",
                 "Give a segmentation with other labels."};
  return soup;
}

} // namespace isoscope
