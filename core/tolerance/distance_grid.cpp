// Finds the places that Ω comes near to by halving boxes, then fills their bricks.
#include "tolerance/distance_grid.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

constexpr double voxel_half_diagonal = 0.8660254037844386;
/// Beyond the level, in voxels: gradients on the boundary look 0.9 voxels along each axis from a point whose
/// φ is up to half a cell's diagonal larger than what is read between samples.
constexpr double margin_voxels = 2.5;
/// Of places along a side: more would be no texture.
constexpr int most_places = 1024;

using Place = std::array<int, 3>;

double reach_of(const GridWish& wish, double voxel) {
  return wish.level * wish.delta + margin_voxels * voxel;
}

/// The lattice for a size of voxels, without bricks.
DistanceGrid lattice(const ToleranceField& field, const GridWish& wish, double voxel) {
  DistanceGrid grid;
  const Box3& whole = wish.within.empty() ? field.bounds() : wish.within;
  const double least_side = whole.longest_edge() / (DistanceGrid::cells * (most_places - 2));
  grid.voxel = std::max(voxel, least_side);
  const double reach = reach_of(wish, grid.voxel), side = DistanceGrid::cells * grid.voxel;
  grid.delta = wish.delta;
  grid.level = static_cast<float>(wish.level);
  grid.reach = static_cast<float>(reach / wish.delta);
  // A place whose middle is a half diagonal out of reach still has its brick.
  grid.clamp = static_cast<float>((reach + 2 * voxel_half_diagonal * side) / wish.delta);
  // Beyond the reach all round: the outermost samples are outside of Ω. A part is taken as it is: cut off
  // there, its lattice would lie along flat walls, where a segment may run through an edge.
  const Box3 wanted = wish.within.empty() ? field.bounds().grown(reach) : wish.within;
  grid.box.lo = wanted.lo;
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    grid.places[axis] =
        std::clamp(static_cast<int>(std::ceil(wanted.extent()[a] / side - 1e-9)), 1, most_places);
    grid.box.hi[a] = grid.box.lo[a] + side * grid.places[axis];
  }
  return grid;
}

/// The places within reach of the input, in an order that keeps neighbours together. Gives up, with more than
/// `most` of them, where there are more.
std::vector<Place> places_near(const DistanceGrid& grid, const ToleranceField& field, double reach,
                               std::size_t most, const RunControl& control) {
  int size = 1;
  while (size < *std::max_element(grid.places.begin(), grid.places.end())) size *= 2;
  const double side = DistanceGrid::cells * grid.voxel;
  std::vector<Place> blocks{{0, 0, 0}}, next;
  std::vector<std::uint8_t> near;
  for (;; size /= 2) {
    near.assign(blocks.size(), 0);
    parallel_until(blocks.size(), 64, control, [&](std::size_t i) {
      const double half = 0.5 * size;
      const Vec3 middle =
          grid.box.lo + side * Vec3{blocks[i][0] + half, blocks[i][1] + half, blocks[i][2] + half};
      // φ is 1-Lipschitz: beyond, no point of the block is within reach.
      const auto is_near = [&](Vec3 at, double block_side) {
        const double within = reach + voxel_half_diagonal * block_side;
        return field.closest_within(at, within * (1 + 1e-9)).distance() <= within;
      };
      bool found = is_near(middle, size * side);
      if (found && size == 1) {
        // Bricks are dear: an eighth of the place has to be near, each with a smaller ball around it.
        found = false;
        for (int c = 0; c < 8 && !found; ++c)
          found = is_near(middle + 0.25 * side *
                                       Vec3{(c & 1) ? 1.0 : -1.0, (c & 2) ? 1.0 : -1.0, (c & 4) ? 1.0 : -1.0},
                          0.5 * side);
      }
      near[i] = found ? 1 : 0;
    });
    if (control.cancelled()) return {};
    next.clear();
    const int half = size / 2;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (near[i] == 0) continue;
      if (size == 1) {
        next.push_back(blocks[i]);
        continue;
      }
      for (int c = 0; c < 8; ++c) {
        const Place p{blocks[i][0] + (c & 1) * half, blocks[i][1] + (c >> 1 & 1) * half,
                      blocks[i][2] + (c >> 2) * half};
        if (p[0] < grid.places[0] && p[1] < grid.places[1] && p[2] < grid.places[2]) next.push_back(p);
      }
    }
    blocks.swap(next);
    if (size == 1 || blocks.size() > 8 * most + 64) return blocks;
  }
}

std::size_t place_count(const DistanceGrid& grid) {
  return static_cast<std::size_t>(grid.places[0]) * static_cast<std::size_t>(grid.places[1]) *
         static_cast<std::size_t>(grid.places[2]);
}

/// Distances of one brick.
void fill(DistanceGrid& grid, std::size_t brick, const ToleranceField& field, double delta) {
  constexpr int n = DistanceGrid::samples;
  const Vec3 corner = grid.corner(grid.at[brick]);
  const double side = DistanceGrid::cells * grid.voxel, radius = voxel_half_diagonal * side;
  const Vec3 middle = corner + 0.5 * side * Vec3{1, 1, 1};
  ClosestPoint last = field.closest(middle);
  TriangleNeighborhood near;
  field.find_neighborhood(middle, (last.distance() + 2 * radius) * (1 + 1e-9), near);
  const double scale = DistanceGrid::most / (static_cast<double>(grid.clamp) * delta);
  std::int16_t* out = grid.values.data() + brick * DistanceGrid::brick_size;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int i = 0; i < n; ++i) {
        const int x = (y + z) % 2 == 0 ? i : n - 1 - i; // to and fro: the last site is a good guess
        last = field.closest_near(corner + grid.voxel * Vec3{static_cast<double>(x), static_cast<double>(y),
                                                             static_cast<double>(z)},
                                  last.triangle, near);
        const double value = std::round(last.distance() * scale);
        out[DistanceGrid::sample(x, y, z)] =
            static_cast<std::int16_t>(std::clamp(value, 1.0, static_cast<double>(DistanceGrid::most)));
      }
}

/// The cell that holds a point and where in it; an outer place beyond the box.
struct InCell {
  std::int32_t entry = DistanceGrid::outer;
  std::array<int, 3> cell{};
  std::array<double, 3> part{};
};
InCell find_cell(const DistanceGrid& grid, Vec3 p) {
  InCell found;
  Place place{};
  for (int a = 0; a < 3; ++a) {
    const auto k = static_cast<std::size_t>(a);
    const double x = (p[a] - grid.box.lo[a]) / grid.voxel;
    if (!(x >= 0) || x >= static_cast<double>(grid.places[k]) * DistanceGrid::cells) return found;
    const int cell = static_cast<int>(x);
    place[k] = cell / DistanceGrid::cells;
    found.cell[k] = cell % DistanceGrid::cells;
    found.part[k] = x - cell;
  }
  found.entry = grid.index[grid.place(place)];
  return found;
}

/// Linear between what `read` makes of the samples around a point.
template <class Read> double interpolated(const DistanceGrid& grid, const InCell& in, const Read& read) {
  const auto brick = grid.brick(static_cast<std::size_t>(in.entry));
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    const int dx = c & 1, dy = c >> 1 & 1, dz = c >> 2;
    const double weight = (dx ? in.part[0] : 1 - in.part[0]) * (dy ? in.part[1] : 1 - in.part[1]) *
                          (dz ? in.part[2] : 1 - in.part[2]);
    sum += weight * read(brick[DistanceGrid::sample(in.cell[0] + dx, in.cell[1] + dy, in.cell[2] + dz)]);
  }
  return sum * static_cast<double>(grid.clamp) / DistanceGrid::most;
}

} // namespace

double DistanceGrid::signed_value(Vec3 p) const {
  const InCell in = find_cell(*this, p);
  if (in.entry < 0) return static_cast<double>(in.entry == inner ? -reach : reach);
  return interpolated(*this, in, [](std::int16_t v) { return v; });
}

double DistanceGrid::value(Vec3 p) const {
  const InCell in = find_cell(*this, p);
  if (in.entry < 0) return static_cast<double>(reach);
  return interpolated(*this, in, [](std::int16_t v) { return std::abs(v); });
}

Result<DistanceGrid> make_distance_grid(const ToleranceField& field, const GridWish& wish,
                                        const RunControl& control) {
  if (!(wish.delta > 0) || !(wish.voxel > 0) || field.empty())
    return Error{ErrorCode::usage, "A distance grid needs an input, a tolerance and a size.", ""};
  const Error cancelled{ErrorCode::cancelled, "Stopped while computing distances.", ""};
  const auto brick_bytes = [&](std::size_t of_a_sample) {
    return DistanceGrid::brick_size * (of_a_sample + wish.side_bytes);
  };
  DistanceGrid grid = lattice(field, wish, wish.voxel);
  while (true) {
    const std::size_t index_bytes = place_count(grid) * sizeof(std::uint32_t);
    const std::size_t room = wish.most_bytes > index_bytes ? wish.most_bytes - index_bytes : 0,
                      most = std::min(room / brick_bytes(1), DistanceGrid::most_bricks);
    grid.at = places_near(grid, field, reach_of(wish, grid.voxel), most, control);
    if (control.cancelled()) return cancelled;
    grid.sample_bytes = grid.at.size() * brick_bytes(2) <= room ? 2 : 1;
    if (grid.at.size() <= most) break;
    // Bricks go with the area that voxels divide, a little more slowly the larger they are.
    const double over = std::sqrt(static_cast<double>(grid.at.size()) / static_cast<double>(most + 1));
    grid = lattice(field, wish, grid.voxel * std::clamp(1.03 * over, 1.05, 2.0));
  }
  grid.side_bytes = wish.side_bytes;
  grid.coarsened = grid.voxel > wish.coarsest * (1 + 1e-9);
  grid.index.assign(place_count(grid), DistanceGrid::outer);
  for (std::size_t i = 0; i < grid.at.size(); ++i)
    grid.index[grid.place(grid.at[i])] = static_cast<std::int32_t>(i);
  grid.values.resize(grid.at.size() * DistanceGrid::brick_size);
  constexpr std::size_t portion = 4096;
  for (std::size_t begin = 0; begin < grid.at.size(); begin += portion) {
    const std::size_t count = std::min(portion, grid.at.size() - begin);
    parallel_until(count, 4, control, [&](std::size_t i) { fill(grid, begin + i, field, wish.delta); });
    if (control.cancelled()) return cancelled;
    control.report("distances", static_cast<double>(begin + count) / static_cast<double>(grid.at.size()));
  }
  return grid;
}

} // namespace isoscope
