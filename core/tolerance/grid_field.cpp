// The field of a grid, its bounds and its components.
#include "tolerance/grid_field.h"

#include "base/disjoint_sets.h"
#include "base/numbers.h"
#include "base/place.h"

#include <algorithm>
#include <utility>

namespace isoscope {
namespace {

constexpr std::uint32_t no_site = 0xffffffffu;
/// Beyond Ω by so much of the band g is flat: φ grows up to (1 + 2 · margin) δ.
constexpr double margin = 0.5;
/// Relative to the largest value: a trilinear value comes from fewer than 32 operations.
constexpr double value_roundings = 64 * std::numeric_limits<double>::epsilon();
/// Pieces of a facet that are looked at before the answer is left open, and cells of one that is bounded.
constexpr std::size_t most_pieces = 4000;
constexpr std::size_t most_cells_of_piece = 27;
/// Regions that are told to the octree, the deepest first.
constexpr std::size_t most_seeds = 512;

bool contains(const Box3& outer, const Box3& inner) {
  for (int a = 0; a < 3; ++a)
    if (inner.lo[a] < outer.lo[a] || inner.hi[a] > outer.hi[a]) return false;
  return true;
}

Error stopped() {
  return {ErrorCode::cancelled, "Stopped while reading the grid.", ""};
}

} // namespace

GridField::GridField(std::shared_ptr<const ScalarGrid> grid, double low, double high,
                     const RunControl& control)
    : grid_(std::move(grid)), function_(*grid_), pyramid_(function_, control), low_(low), high_(high) {
  for (std::size_t a = 0; a < 3; ++a) cells_[a] = grid_->size[a] - 1;
  float largest = 0;
  for (const float v : grid_->values) largest = std::max(largest, std::abs(v));
  value_rounding_ = value_roundings * static_cast<double>(largest);
}

Result<std::shared_ptr<const GridField>> GridField::make(std::shared_ptr<const ScalarGrid> grid, double low,
                                                         double high, const RunControl& control) {
  if (!std::isfinite(low) || !std::isfinite(high) || !(low < high))
    return Error{ErrorCode::usage,
                 "The levels " + shortest(low) + " and " + shortest(high) + " hold nothing between them.",
                 "Give the lower one first."};
  if (grid->values.size() >= no_site)
    return Error{ErrorCode::unsupported, "The grid has more than 4 billion voxels.", "Crop or resample it."};
  std::shared_ptr<GridField> field(new GridField(std::move(grid), low, high, control));
  if (Status values = field->check_values(); !values) return values.error();
  if (Status border = field->check_border(); !border) return border.error();
  field->measure(control);
  field->collect_sites(control);
  field->find_seeds(control);
  if (control.cancelled()) return stopped();
  return std::shared_ptr<const GridField>(std::move(field));
}

template <class Visit> void GridField::for_each_cell(const RunControl& control, const Visit& visit) const {
  for (std::size_t z = 0; z < cells_[2] && !control.cancelled(); ++z)
    for (std::size_t y = 0; y < cells_[1]; ++y)
      for (std::size_t x = 0; x < cells_[0]; ++x) visit(GridCell{x, y, z});
}

/// Whether there is something on both sides of the band.
Status GridField::check_values() const {
  const auto [least, most] = std::minmax_element(grid_->values.begin(), grid_->values.end());
  const auto at = [&](auto found) {
    const auto i = static_cast<std::size_t>(found - grid_->values.begin());
    const std::size_t row = grid_->size[0], slice = row * grid_->size[1];
    return place(grid_->point(i % row, i / row % grid_->size[1], i / slice), place_digits);
  };
  if (!(static_cast<double>(*least) < low_))
    return Error{ErrorCode::bad_input,
                 "No value of the grid is below the level " + shortest(low_) + ": the least is " +
                     general(static_cast<double>(*least), 6) + ", at " + at(least) + ".",
                 "Give levels within the values."};
  if (!(static_cast<double>(*most) > high_))
    return Error{ErrorCode::bad_input,
                 "No value of the grid is above the level " + shortest(high_) + ": the largest is " +
                     general(static_cast<double>(*most), 6) + ", at " + at(most) + ".",
                 "Give levels within the values."};
  return {};
}

/// All of the border must lie on one side, which is the outside.
Status GridField::check_border() {
  const auto side_of = [&](float v) {
    return static_cast<double>(v) < low_ ? -1 : (static_cast<double>(v) > high_ ? +1 : 0);
  };
  const int outside = side_of(grid_->values.front());
  const auto& n = grid_->size;
  for (std::size_t z = 0; z < n[2]; ++z)
    for (std::size_t y = 0; y < n[1]; ++y) {
      const bool whole_row = z == 0 || z + 1 == n[2] || y == 0 || y + 1 == n[1];
      for (std::size_t x = 0; x < n[0]; x += whole_row ? 1 : n[0] - 1) {
        const int side = side_of(grid_->at(x, y, z));
        if (side != 0 && side == outside) continue;
        return Error{ErrorCode::bad_input,
                     "What lies between the levels reaches the border of the grid, near " +
                         place(grid_->point(x, y, z), place_digits) + ".",
                     "Pad the grid with values of its outside, or give other levels."};
      }
    }
  high_side_ = outside;
  return {};
}

/// L and δ, and the area of the surface halfway between the levels: a plane of any direction meets, on the
/// average, (sx + sy + sz) / 2V cells of volume V a unit of its area.
void GridField::measure(const RunControl& control) {
  const double reach = margin * (high_ - low_), middle = 0.5 * (low_ + high_);
  std::size_t crossed = 0;
  for_each_cell(control, [&](const GridCell& c) {
    const ValueRange r = function_.range(c);
    if (!r.meets(low_ - reach, high_ + reach)) return;
    slope_ = std::max(slope_, function_.steepest(c));
    crossed += r.meets(middle, middle) ? 1 : 0;
  });
  slope_ *= 1 + 1e-12;
  delta_ = (high_ - low_) / (2 * slope_);
  const Vec3 s = grid_->spacing;
  area_ = static_cast<double>(crossed) * 2 * s.x * s.y * s.z / (s.x + s.y + s.z);
}

/// Numbers the cells of the band, and gives every other cell the site of one near it.
void GridField::collect_sites(const RunControl& control) {
  site_of_cell_.assign(cells_[0] * cells_[1] * cells_[2], no_site);
  std::vector<std::uint32_t> queue;
  for_each_cell(control, [&](const GridCell& c) {
    if (!function_.range(c).meets(low_, high_)) return;
    const std::size_t i = cell_index(c);
    site_of_cell_[i] = static_cast<std::uint32_t>(cell_of_site_.size());
    cell_of_site_.push_back(static_cast<std::uint32_t>(i));
    queue.push_back(static_cast<std::uint32_t>(i));
    bounds_.add(grid_->point(c[0], c[1], c[2]));
    bounds_.add(grid_->point(c[0] + 1, c[1] + 1, c[2] + 1));
  });
  SparsePoll poll(control);
  for (std::size_t next = 0; next < queue.size() && !poll.cancelled(); ++next) {
    const GridCell c = cell_at(queue[next]);
    for (std::size_t a = 0; a < 3; ++a)
      for (const bool up : {false, true}) {
        if (up ? c[a] + 1 == cells_[a] : c[a] == 0) continue;
        GridCell other = c;
        other[a] += up ? 1 : std::size_t(-1);
        const std::size_t i = cell_index(other);
        if (site_of_cell_[i] != no_site) continue;
        site_of_cell_[i] = site_of_cell_[queue[next]];
        queue.push_back(static_cast<std::uint32_t>(i));
      }
  }
}

/// The deepest voxel of each group beyond a level that edges of the grid join: each part of the outside of Ω
/// holds one, since on every line along an axis a trilinear function rises up to a border of its cell in one
/// of both directions.
void GridField::find_seeds(const RunControl& control) {
  const auto n = static_cast<std::uint32_t>(grid_->values.size());
  const auto depth = [&](std::uint32_t i) {
    const auto v = static_cast<double>(grid_->values[i]);
    return std::max(v - high_, low_ - v);
  };
  const auto side = [&](std::uint32_t i) { return static_cast<double>(grid_->values[i]) > high_; };
  DisjointSets sets(n);
  const std::array<std::size_t, 3> strides{1, grid_->size[0], grid_->size[0] * grid_->size[1]};
  SparsePoll poll(control);
  const auto position = [&](std::uint32_t i) {
    return GridCell{i % grid_->size[0], i / strides[1] % grid_->size[1], i / strides[2]};
  };
  for (std::uint32_t i = 0; i < n && !poll.cancelled(); ++i) {
    if (!(depth(i) > 0)) continue;
    const GridCell at = position(i);
    for (std::size_t a = 0; a < 3; ++a) {
      if (at[a] + 1 == grid_->size[a]) continue;
      const auto j = static_cast<std::uint32_t>(i + strides[a]);
      if (depth(j) > 0 && side(i) == side(j)) sets.unite(i, j);
    }
  }
  std::vector<std::uint32_t> deepest(n, no_site);
  for (std::uint32_t i = 0; i < n && !poll.cancelled(); ++i) {
    if (!(depth(i) > 0)) continue;
    std::uint32_t& best = deepest[sets.find(i)];
    if (best == no_site || depth(i) > depth(best)) best = i;
  }
  std::erase(deepest, no_site);
  std::stable_sort(deepest.begin(), deepest.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return depth(a) > depth(b); });
  deepest.resize(std::min(deepest.size(), most_seeds));
  for (const std::uint32_t i : deepest) {
    const GridCell at = position(i);
    seeds_.push_back(grid_->point(at[0], at[1], at[2]));
  }
}

double GridField::phi(double g) const {
  const double reach = margin * (high_ - low_);
  const double clamped = std::clamp(g, low_ - reach, high_ + reach);
  return std::max(0.0, std::max(clamped - high_, low_ - clamped) / slope_ + delta_);
}

Vec3 GridField::gradient(Vec3 p, const CellPosition& at, double g) const {
  const double reach = margin * (high_ - low_), middle = 0.5 * (low_ + high_);
  if (!(std::abs(g - middle) < 0.5 * (high_ - low_) + reach)) return {};
  Vec3 slope = ((g > middle ? 1 : -1) / slope_) * function_.gradient(at);
  for (int a = 0; a < 3; ++a) // beyond the grid the nearest point of it counts
    if (p[a] < function_.box().lo[a] || p[a] > function_.box().hi[a]) slope[a] = 0;
  return slope;
}

ClosestPoint GridField::closest(Vec3 p) const {
  const CellPosition at = function_.locate(p);
  const double g = function_.value(at), f = phi(g);
  ClosestPoint found{p, f * f, TriangleId(site_of_cell_[cell_index(at.cell)])};
  if (f > 0) found.point = p - f * normalized(gradient(p, at, g));
  return found;
}

Vec3 GridField::gradient(Vec3 p, const ClosestPoint& at) const {
  if (!(at.squared_distance > 0)) return {};
  const CellPosition position = function_.locate(p);
  return gradient(p, position, function_.value(position));
}

Vec3 GridField::place_of(TriangleId site) const {
  const GridCell c = cell_at(cell_of_site_[site.index()]);
  return 0.5 * (grid_->point(c[0], c[1], c[2]) + grid_->point(c[0] + 1, c[1] + 1, c[2] + 1));
}

std::optional<ToleranceField::Range> GridField::range_in_cube(Vec3 center, double half_side) const {
  const Vec3 reach = Vec3{1, 1, 1} * half_side;
  ValueRange g = pyramid_.range({center - reach, center + reach});
  g.least -= value_rounding_;
  g.most += value_rounding_;
  const double middle = std::clamp(0.5 * (low_ + high_), g.least, g.most);
  Range found{phi(middle), std::max(phi(g.least), phi(g.most))};
  const double at_center = closest(center).distance(), way = std::sqrt(3.0) * half_side * (1 + 1e-7);
  found.least = std::max(found.least, at_center - way);
  found.most = std::min(found.most, at_center + way);
  return found;
}

/// Contains g on a piece of few cells: it differs from the linear function between the corners by at most
/// half of what its slopes along each axis vary by on the way.
ValueRange GridField::range_on_piece(const Triangle3& piece, const Vec3& values) const {
  Box3 box;
  for (const Vec3 p : piece) box.add(p);
  const auto [first, last] = pyramid_.cells(box);
  std::array<ValueRange, 3> slopes;
  for (std::size_t z = first[2]; z <= last[2]; ++z)
    for (std::size_t y = first[1]; y <= last[1]; ++y)
      for (std::size_t x = first[0]; x <= last[0]; ++x) {
        CellPosition corner{{x, y, z}, {}};
        Vec3 lo, hi;
        for (int a = 0; a < 3; ++a) {
          const auto begin = static_cast<double>(corner.cell[static_cast<std::size_t>(a)]);
          lo[a] = std::clamp((box.lo[a] - grid_->origin[a]) / grid_->spacing[a] - begin, 0.0, 1.0);
          hi[a] = std::clamp((box.hi[a] - grid_->origin[a]) / grid_->spacing[a] - begin, 0.0, 1.0);
        }
        for (unsigned k = 0; k < 8; ++k) {
          for (int a = 0; a < 3; ++a) corner.at[a] = (k >> a & 1u) ? hi[a] : lo[a];
          const Vec3 slope = function_.gradient(corner);
          for (std::size_t a = 0; a < 3; ++a) slopes[a].add(slope[static_cast<int>(a)]);
        }
      }
  double bend = value_rounding_;
  for (int a = 0; a < 3; ++a) {
    const ValueRange& s = slopes[static_cast<std::size_t>(a)];
    bend += 0.25 * (s.most - s.least) * (box.hi[a] - box.lo[a]);
  }
  ValueRange range;
  for (int i = 0; i < 3; ++i) range.add(values[i]);
  return {range.least - bend, range.most + bend};
}

std::optional<bool> GridField::meets_boundary(const Triangle3& facet) const {
  const auto within = [&](double least, double most) {
    return least - value_rounding_ > low_ && most + value_rounding_ < high_;
  };
  std::vector<Triangle3> pieces{facet};
  bool any_inside = false;
  for (std::size_t looked = 0; !pieces.empty(); ++looked) {
    if (looked == most_pieces) return std::nullopt;
    const Triangle3 piece = pieces.back();
    pieces.pop_back();
    Vec3 values;
    std::size_t longest = 0;
    double length2 = -1;
    bool outside = false;
    Box3 box;
    for (std::size_t i = 0; i < 3; ++i) {
      values[static_cast<int>(i)] = function_.value(piece[i]);
      (within(values[static_cast<int>(i)], values[static_cast<int>(i)]) ? any_inside : outside) = true;
      const double e2 = squared_length(piece[(i + 1) % 3] - piece[i]);
      if (e2 > length2) length2 = e2, longest = i;
      box.add(piece[i]);
    }
    if (outside) return any_inside ? std::optional(true) : std::nullopt;
    const ValueRange coarse = pyramid_.range(box);
    if (within(coarse.least, coarse.most)) continue;
    const auto [first, last] = pyramid_.cells(box);
    std::size_t count = 1;
    for (std::size_t a = 0; a < 3; ++a) count *= last[a] - first[a] + 1;
    // Beyond the grid its function has bends that the slopes of its cells do not show.
    const bool in_grid = contains(function_.box(), box);
    if (count <= most_cells_of_piece && in_grid) {
      const ValueRange fine = range_on_piece(piece, values);
      if (within(fine.least, fine.most)) continue;
    }
    const std::size_t next = (longest + 1) % 3;
    const Vec3 middle = 0.5 * (piece[longest] + piece[next]);
    Triangle3 half = piece;
    half[longest] = middle;
    pieces.push_back(half);
    half = piece;
    half[next] = middle;
    pieces.push_back(half);
  }
  return false;
}

int GridField::side(Vec3 p) const {
  return function_.value(p) > 0.5 * (low_ + high_) ? high_side_ : -high_side_;
}

/// Two cells are joined where {φ <= r} meets their common face: a trilinear function takes all values between
/// those of the face's corners.
VolumeComponents GridField::components(double r, const RunControl& control) const {
  const double inset = std::max(0.0, delta_ - r) * slope_, low = low_ + inset, high = high_ - inset;
  DisjointSets sets(cell_of_site_.size());
  std::vector<char> holds(cell_of_site_.size());
  SparsePoll poll(control);
  for (std::uint32_t s = 0; s < cell_of_site_.size() && !poll.cancelled(); ++s) {
    const GridCell c = cell_at(cell_of_site_[s]);
    holds[s] = function_.range(c).meets(low, high);
    for (std::size_t a = 0; a < 3; ++a) {
      if (c[a] == 0) continue;
      GridCell other = c;
      --other[a];
      const std::uint32_t t = site_of_cell_[cell_index(other)];
      if (cell_of_site_[t] != cell_index(other)) continue;
      ValueRange face;
      for (std::size_t k = 0; k < 4; ++k) {
        GridCell corner = c;
        corner[(a + 1) % 3] += k & 1;
        corner[(a + 2) % 3] += k >> 1;
        face.add(static_cast<double>(grid_->at(corner[0], corner[1], corner[2])));
      }
      if (face.meets(low, high)) sets.unite(s, t);
    }
  }
  VolumeComponents result;
  result.of_triangle.assign(cell_of_site_.size(), VolumeComponents::none);
  for (std::uint32_t s = 0; s < cell_of_site_.size(); ++s) {
    if (!holds[s]) continue;
    const std::uint32_t root = sets.find(s);
    if (root == s)
      result.of_triangle[s] = static_cast<std::uint32_t>(result.count++);
    else
      result.of_triangle[s] = result.of_triangle[root];
  }
  return result;
}

std::size_t GridField::memory_bytes() const {
  return grid_->values.capacity() * sizeof(float) + pyramid_.memory_bytes() +
         (site_of_cell_.capacity() + cell_of_site_.capacity()) * sizeof(std::uint32_t) +
         seeds_.capacity() * sizeof(Vec3);
}

} // namespace isoscope
