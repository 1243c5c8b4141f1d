// Trilinear values and their ranges.
#include "tolerance/value_range.h"

namespace isoscope {

CellPosition TrilinearFunction::locate(Vec3 p) const {
  CellPosition found;
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const double x = (std::clamp(p[a], box_.lo[a], box_.hi[a]) - grid_->origin[a]) / grid_->spacing[a];
    const std::size_t cell = std::min(static_cast<std::size_t>(std::max(0.0, x)), grid_->size[axis] - 2);
    found.cell[axis] = cell;
    found.at[a] = std::clamp(x - static_cast<double>(cell), 0.0, 1.0);
  }
  return found;
}

double TrilinearFunction::value(const CellPosition& p) const {
  const std::size_t dx = 1, dy = grid_->size[0], dz = grid_->size[0] * grid_->size[1];
  const float* v = grid_->values.data() + grid_->index(p.cell[0], p.cell[1], p.cell[2]);
  const auto mix = [](double a, double b, double t) { return (1 - t) * a + t * b; };
  const auto along_x = [&](std::size_t at) {
    return mix(static_cast<double>(v[at]), static_cast<double>(v[at + dx]), p.at.x);
  };
  return mix(mix(along_x(0), along_x(dy), p.at.y), mix(along_x(dz), along_x(dy + dz), p.at.y), p.at.z);
}

double TrilinearFunction::slope(const CellPosition& p, std::size_t axis) const {
  const std::size_t strides[3] = {1, grid_->size[0], grid_->size[0] * grid_->size[1]};
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const float* at = grid_->values.data() + grid_->index(p.cell[0], p.cell[1], p.cell[2]);
  const auto rise = [&](std::size_t offset) {
    return static_cast<double>(at[offset + strides[axis]]) - static_cast<double>(at[offset]);
  };
  const double s = p.at[static_cast<int>(u)], t = p.at[static_cast<int>(v)];
  const double mixed = (1 - t) * ((1 - s) * rise(0) + s * rise(strides[u])) +
                       t * ((1 - s) * rise(strides[v]) + s * rise(strides[u] + strides[v]));
  return mixed / grid_->spacing[static_cast<int>(axis)];
}

Vec3 TrilinearFunction::gradient(const CellPosition& p) const {
  return {slope(p, 0), slope(p, 1), slope(p, 2)};
}

ValueRange TrilinearFunction::range(const GridCell& cell) const {
  ValueRange r;
  for (std::size_t k = 0; k < 8; ++k)
    r.add(static_cast<double>(grid_->at(cell[0] + (k & 1), cell[1] + (k >> 1 & 1), cell[2] + (k >> 2))));
  return r;
}

double TrilinearFunction::steepest(const GridCell& cell) const {
  double squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double largest = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      CellPosition corner{cell, {}};
      corner.at[static_cast<int>((axis + 1) % 3)] = static_cast<double>(k & 1);
      corner.at[static_cast<int>((axis + 2) % 3)] = static_cast<double>(k >> 1);
      largest = std::max(largest, std::abs(slope(corner, axis)));
    }
    squared += largest * largest;
  }
  return std::sqrt(squared);
}

ValuePyramid::ValuePyramid(const TrilinearFunction& function, const RunControl& control)
    : function_(&function) {
  const std::array<std::size_t, 3>& points = function.grid().size;
  std::array<std::size_t, 3> below{points[0] - 1, points[1] - 1, points[2] - 1};
  while (std::max({below[0], below[1], below[2]}) > 1) {
    if (control.cancelled()) return;
    Level level;
    for (std::size_t a = 0; a < 3; ++a) level.size[a] = (below[a] + 1) / 2;
    level.least.reserve(level.size[0] * level.size[1] * level.size[2]);
    level.most.reserve(level.least.capacity());
    const Level* finer = levels_.empty() ? nullptr : &levels_.back();
    for (std::size_t z = 0; z < level.size[2]; ++z)
      for (std::size_t y = 0; y < level.size[1]; ++y)
        for (std::size_t x = 0; x < level.size[0]; ++x) {
          ValueRange r;
          for (std::size_t k = 0; k < 8; ++k) {
            const GridCell c{2 * x + (k & 1), 2 * y + (k >> 1 & 1), 2 * z + (k >> 2)};
            if (c[0] >= below[0] || c[1] >= below[1] || c[2] >= below[2]) continue;
            if (finer == nullptr) {
              r.add(function.range(c));
              continue;
            }
            const std::size_t i = (c[2] * below[1] + c[1]) * below[0] + c[0];
            r.add({static_cast<double>(finer->least[i]), static_cast<double>(finer->most[i])});
          }
          level.least.push_back(static_cast<float>(r.least)); // values are floats: nothing is rounded
          level.most.push_back(static_cast<float>(r.most));
        }
    below = level.size;
    levels_.push_back(std::move(level));
  }
}

std::array<GridCell, 2> ValuePyramid::cells(const Box3& box) const {
  // The ends may be rounded into the next cell: a cell more is looked at where they lie on a border.
  constexpr double rounding = 1e-9;
  std::array<GridCell, 2> found;
  const ScalarGrid& grid = function_->grid();
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const double last = static_cast<double>(grid.size[axis] - 2);
    const double lo = (box.lo[a] - grid.origin[a]) / grid.spacing[a] - rounding;
    const double hi = (box.hi[a] - grid.origin[a]) / grid.spacing[a] + rounding;
    found[0][axis] = static_cast<std::size_t>(std::clamp(std::floor(lo), 0.0, last));
    found[1][axis] = static_cast<std::size_t>(std::clamp(std::floor(hi), 0.0, last));
  }
  return found;
}

ValueRange ValuePyramid::exact_range(const Box3& box, const std::array<GridCell, 2>& cells) const {
  const ScalarGrid& grid = function_->grid();
  ValueRange r;
  for (std::size_t z = cells[0][2]; z <= cells[1][2]; ++z)
    for (std::size_t y = cells[0][1]; y <= cells[1][1]; ++y)
      for (std::size_t x = cells[0][0]; x <= cells[1][0]; ++x) {
        CellPosition corner{{x, y, z}, {}};
        Vec3 lo, hi;
        for (int a = 0; a < 3; ++a) {
          const auto first = static_cast<double>(corner.cell[static_cast<std::size_t>(a)]);
          lo[a] = std::clamp((box.lo[a] - grid.origin[a]) / grid.spacing[a] - first, 0.0, 1.0);
          hi[a] = std::clamp((box.hi[a] - grid.origin[a]) / grid.spacing[a] - first, 0.0, 1.0);
        }
        for (unsigned k = 0; k < 8; ++k) {
          for (int a = 0; a < 3; ++a) corner.at[a] = (k >> a & 1u) ? hi[a] : lo[a];
          r.add(function_->value(corner));
        }
      }
  return r;
}

ValueRange ValuePyramid::range(const Box3& box) const {
  std::array<GridCell, 2> c = cells(box);
  const auto count = [&] {
    return (c[1][0] - c[0][0] + 1) * (c[1][1] - c[0][1] + 1) * (c[1][2] - c[0][2] + 1);
  };
  if (levels_.empty() || count() <= most_exact_cells) return exact_range(box, c);
  std::size_t at = 0;
  const auto coarsen = [&] {
    for (GridCell& corner : c)
      for (std::size_t& x : corner) x /= 2;
  };
  coarsen();
  for (; at + 1 < levels_.size() && count() > most_exact_cells; ++at) coarsen();
  const Level& level = levels_[at];
  ValueRange r;
  for (std::size_t z = c[0][2]; z <= c[1][2]; ++z)
    for (std::size_t y = c[0][1]; y <= c[1][1]; ++y)
      for (std::size_t x = c[0][0]; x <= c[1][0]; ++x) {
        const std::size_t i = (z * level.size[1] + y) * level.size[0] + x;
        r.add({static_cast<double>(level.least[i]), static_cast<double>(level.most[i])});
      }
  return r;
}

std::size_t ValuePyramid::memory_bytes() const {
  std::size_t bytes = 0;
  for (const Level& level : levels_)
    bytes += (level.least.capacity() + level.most.capacity()) * sizeof(float);
  return bytes;
}

} // namespace isoscope
