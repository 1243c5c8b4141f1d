// On which side each voxel of a distance grid lies.
#include "tolerance/grid_sides.h"

#include <algorithm>
#include <utility>

namespace isoscope {
namespace {

/// Addresses of voxels and their neighbours.
struct Voxels {
  explicit Voxels(const DistanceGrid& g) : grid(g) {
    const Vec3 extent = g.box.extent();
    for (int i = 0; i < 3; ++i) step[i] = extent[i] / g.size[static_cast<std::size_t>(i)];
    stride = {1, static_cast<std::size_t>(g.size[0]), static_cast<std::size_t>(g.size[0]) * g.size[1]};
  }
  std::array<int, 3> coordinates(std::size_t voxel) const {
    return {static_cast<int>(voxel % stride[1]), static_cast<int>(voxel / stride[1] % grid.size[1]),
            static_cast<int>(voxel / stride[2])};
  }
  Vec3 center(std::size_t voxel) const {
    const auto c = coordinates(voxel);
    return grid.box.lo + Vec3{(c[0] + 0.5) * step.x, (c[1] + 0.5) * step.y, (c[2] + 0.5) * step.z};
  }
  /// The voxel that holds p, clamped to the grid.
  std::size_t at(Vec3 p) const {
    std::size_t voxel = 0;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double x = (p[i] - grid.box.lo[i]) / step[i];
      voxel += stride[k] * static_cast<std::size_t>(std::clamp(static_cast<int>(x), 0, grid.size[k] - 1));
    }
    return voxel;
  }
  /// Calls visit(neighbour, distance between the centres) for the up to six neighbours.
  template <class Visit> void for_each_neighbor(std::size_t voxel, Visit&& visit) const {
    const auto c = coordinates(voxel);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double gap = step[static_cast<int>(axis)];
      if (c[axis] > 0) visit(voxel - stride[axis], gap);
      if (c[axis] + 1 < grid.size[axis]) visit(voxel + stride[axis], gap);
    }
  }

  const DistanceGrid& grid;
  Vec3 step;
  std::array<std::size_t, 3> stride{};
};

} // namespace

Status find_sides(DistanceGrid& grid, const ToleranceField& field, const InputSides& sides_of_input,
                  double delta, std::span<const Region> regions, const RunControl& control) {
  const Voxels voxels(grid);
  std::vector<std::int8_t> sides(grid.values.size(), 0);
  std::vector<std::size_t> queue;
  const auto give = [&](std::size_t voxel, std::int8_t side) {
    if (sides[voxel] != 0) return;
    sides[voxel] = side;
    queue.push_back(voxel);
  };
  const Error cancelled{ErrorCode::cancelled, "The picture of the tolerance volume was cancelled.", ""};
  std::size_t next = 0;
  // The distance is 1-Lipschitz: where d(a) + d(b) exceeds |ab|, the input does not meet the segment ab.
  // Without an input surface it is Ω that divides the sides.
  const bool has_surface = field.surface() != nullptr;
  const auto beyond = [&](std::size_t voxel) { return static_cast<double>(grid.values[voxel]) > 1; };
  const auto spread_proven = [&]() {
    for (; next < queue.size(); ++next) {
      if ((next & 0xffffu) == 0 && control.cancelled()) return false;
      const std::size_t voxel = queue[next];
      const double own = static_cast<double>(grid.values[voxel]) * delta;
      voxels.for_each_neighbor(voxel, [&](std::size_t other, double gap) {
        const bool joined = has_surface ? own + static_cast<double>(grid.values[other]) * delta > gap
                                        : beyond(voxel) && beyond(other);
        if (joined) give(other, sides[voxel]);
      });
    }
    return true;
  };
  // Whatever lies outside the input's bounding box lies outside.
  const Box3& input = field.bounds();
  for (std::size_t voxel = 0; voxel < sides.size(); ++voxel) {
    const Vec3 p = voxels.center(voxel);
    bool outside = false;
    for (int i = 0; i < 3; ++i) outside = outside || p[i] < input.lo[i] || p[i] > input.hi[i];
    if (outside) give(voxel, 1);
  }
  if (queue.empty()) give(0, static_cast<std::int8_t>(sides_of_input.label(voxels.center(0))));
  if (!spread_proven()) return cancelled;
  for (const Region& region : regions) {
    const std::size_t voxel = voxels.at(region.deepest);
    // Only a voxel whose centre is certainly in the same region may speak for it.
    if (distance(voxels.center(voxel), region.deepest) < region.depth)
      give(voxel, static_cast<std::int8_t>(region.label > 0 ? 1 : -1));
  }
  if (!spread_proven()) return cancelled;
  // What is left lies along the input or in small pockets.
  for (std::size_t done = 0; done < queue.size(); ++done) {
    if ((done & 0xffu) == 0 && control.cancelled()) return cancelled;
    const std::size_t voxel = queue[done];
    voxels.for_each_neighbor(voxel, [&](std::size_t other, double) {
      if (sides[other] != 0) return;
      const int label = sides_of_input.label_across(voxels.center(voxel), sides[voxel], voxels.center(other));
      give(other, static_cast<std::int8_t>(label));
    });
  }
  grid.sides = std::move(sides);
  return {};
}

} // namespace isoscope
