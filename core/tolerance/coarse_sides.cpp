// Distances first, then what they prove, then what rays tell.
#include "tolerance/coarse_sides.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace isoscope {

std::array<int, 3> CoarseSides::coordinates(std::size_t i) const {
  const auto row = static_cast<std::size_t>(size_[0]), column = static_cast<std::size_t>(size_[1]);
  return {static_cast<int>(i % row), static_cast<int>(i / row % column),
          static_cast<int>(i / (row * column))};
}

std::size_t CoarseSides::number(std::array<int, 3> c) const {
  return (static_cast<std::size_t>(c[2]) * static_cast<std::size_t>(size_[1]) +
          static_cast<std::size_t>(c[1])) *
             static_cast<std::size_t>(size_[0]) +
         static_cast<std::size_t>(c[0]);
}

Vec3 CoarseSides::position(std::array<int, 3> c) const {
  return low_ +
         spacing_ * Vec3{static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
}

std::array<int, 3> CoarseSides::nearest(Vec3 p) const {
  std::array<int, 3> c{};
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    c[axis] = static_cast<int>(std::clamp(std::round((p[a] - low_[a]) / spacing_), 0.0, size_[axis] - 1.0));
  }
  return c;
}

template <class Visit> void CoarseSides::for_each_neighbor(std::size_t i, Visit&& visit) const {
  const auto c = coordinates(i);
  std::size_t stride = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (c[axis] > 0) visit(i - stride);
    if (c[axis] + 1 < size_[axis]) visit(i + stride);
    stride *= static_cast<std::size_t>(size_[axis]);
  }
}

Result<CoarseSides> CoarseSides::find(const SidedInput& input, const Box3& box, double spacing,
                                      const RunControl& control) {
  CoarseSides found;
  found.spacing_ = spacing;
  // The outermost points lie beyond the box.
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    found.size_[axis] = static_cast<int>(std::ceil(box.extent()[a] / spacing)) + 2;
    found.low_[a] = box.center()[a] - 0.5 * spacing * (found.size_[axis] - 1);
  }
  const auto rows = static_cast<std::size_t>(found.size_[1]) * static_cast<std::size_t>(found.size_[2]);
  const auto row = static_cast<std::size_t>(found.size_[0]);
  found.phi_.resize(rows * row);
  parallel_until(rows, 4, control, [&](std::size_t r) {
    TriangleId last;
    for (std::size_t i = r * row; i < (r + 1) * row; ++i) {
      const ClosestPoint at = input.field.closest_near(found.position(found.coordinates(i)), last);
      last = at.triangle;
      found.phi_[i] = at.distance();
    }
  });
  if (control.cancelled() || !found.spread(input, control))
    return Error{ErrorCode::cancelled, "The picture of the tolerance volume was cancelled.", ""};
  return found;
}

bool CoarseSides::spread(const SidedInput& input, const RunControl& control) {
  sides_.assign(phi_.size(), 0);
  std::vector<std::size_t> queue;
  const auto give = [&](std::size_t i, int side) {
    if (sides_[i] != 0) return;
    sides_[i] = static_cast<std::int8_t>(side);
    queue.push_back(i);
  };
  std::size_t next = 0;
  const auto spread_proven = [&] {
    for (; next < queue.size(); ++next) {
      if ((next & 0xffffu) == 0 && control.cancelled()) return false;
      const std::size_t i = queue[next];
      for_each_neighbor(i, [&](std::size_t other) {
        if (input.joined(phi_[i], phi_[other], spacing_)) give(other, sides_[i]);
      });
    }
    return true;
  };
  // Whatever lies outside the input's bounding box lies outside.
  const Box3& bounds = input.field.bounds();
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Vec3 p = position(coordinates(i));
    bool outside = false;
    for (int a = 0; a < 3; ++a) outside = outside || p[a] < bounds.lo[a] || p[a] > bounds.hi[a];
    if (outside) give(i, 1);
  }
  if (!spread_proven()) return false;
  const bool has_surface = input.field.surface() != nullptr;
  for (const Region& region : input.regions) {
    const std::array<int, 3> c = nearest(region.deepest);
    // Only a point that is certainly in the same region may speak for it.
    if (distance(position(c), region.deepest) < region.depth - (has_surface ? 0 : input.delta))
      give(number(c), region.label > 0 ? 1 : -1);
  }
  if (!spread_proven()) return false;
  // Regions that nobody named: many rays tell of one point, what joins it follows. One segment that grazes an
  // edge must not speak for them.
  for (std::size_t i = 0; has_surface && input.tells_sides() && i < sides_.size(); ++i) {
    if (sides_[i] != 0 || phi_[i] <= 0.5 * spacing_) continue;
    if (control.cancelled()) return false;
    give(i, input.sides.label(position(coordinates(i))));
    if (!spread_proven()) return false;
  }
  // Between rooms nothing tells whether a wall that is crossed leads outside: what is left there stays
  // unknown.
  if (has_surface && !input.tells_sides()) return true;
  // What is left lies along the input or in small pockets. What lies on the input tells nobody whether one
  // crosses it: it waits, and spreads nothing before.
  const auto is_on_input = [&](std::size_t i) { return has_surface && phi_[i] < 1e-3 * spacing_; };
  for (const bool waiting : {false, true})
    for (std::size_t done = 0; done < queue.size(); ++done) {
      if ((done & 0xffu) == 0 && control.cancelled()) return false;
      const std::size_t i = queue[done];
      for_each_neighbor(i, [&](std::size_t other) {
        if (sides_[other] != 0 || (!waiting && (is_on_input(i) || is_on_input(other)))) return;
        give(other,
             input.sides.label_across(position(coordinates(i)), sides_[i], position(coordinates(other))));
      });
    }
  return true;
}

int CoarseSides::nearest_side(Vec3 p) const {
  const std::array<int, 3> c = nearest(p);
  // Few are unknown, and none far from all others.
  for (int reach = 0; reach <= 3; ++reach)
    for (int dz = -reach; dz <= reach; ++dz)
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
          const std::array<int, 3> near{c[0] + dx, c[1] + dy, c[2] + dz};
          bool within = true;
          for (std::size_t a = 0; a < 3; ++a) within = within && near[a] >= 0 && near[a] < size_[a];
          if (within && sides_[number(near)] != 0) return sides_[number(near)];
        }
  return +1;
}

int CoarseSides::side(const SidedInput& input, Vec3 p, double phi) const {
  std::array<int, 3> low{}, high{};
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const int cell = static_cast<int>(std::floor((p[a] - low_[a]) / spacing_));
    low[axis] = std::clamp(cell - 1, 0, size_[axis] - 1);
    high[axis] = std::clamp(cell + 2, 0, size_[axis] - 1);
  }
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x) {
        const std::array<int, 3> c{x, y, z};
        const std::size_t i = number(c);
        if (sides_[i] != 0 && input.joined(phi_[i], phi, distance(position(c), p))) return sides_[i];
      }
  return 0;
}

} // namespace isoscope
