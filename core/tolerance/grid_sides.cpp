// Each brick by itself where the coarse lattice tells, then from brick to brick, then across the input.
#include "tolerance/grid_sides.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

constexpr int n = DistanceGrid::samples;
constexpr std::array<int, 3> strides{1, n, n* n};
/// Of the coarse lattice along the longest side, at most.
constexpr double coarse_points = 64;

using Place = std::array<int, 3>;

class BrickSides {
 public:
  BrickSides(DistanceGrid& grid, const SidedInput& input, const CoarseSides& coarse)
      : grid_(grid), input_(input), coarse_(coarse),
        unit_(static_cast<double>(grid.clamp) * input.delta / DistanceGrid::most),
        has_surface_(input.field.surface() != nullptr), sides_(grid.values.size(), 0) {}

  /// False when cancelled.
  bool find(const RunControl& control);

 private:
  /// At most φ: values are rounded, and what they prove must hold of φ itself.
  double phi(std::size_t brick, std::size_t sample) const {
    return unit_ * (grid_.values[brick * DistanceGrid::brick_size + sample] - 1);
  }
  std::int8_t* of(std::size_t brick) { return sides_.data() + brick * DistanceGrid::brick_size; }
  Vec3 position(std::size_t brick, std::size_t sample) const {
    const auto i = static_cast<int>(sample);
    return grid_.corner(grid_.at[brick]) + grid_.voxel * Vec3{static_cast<double>(i % n),
                                                              static_cast<double>(i / n % n),
                                                              static_cast<double>(i / (n * n))};
  }
  bool joined(double a, double b) const {
    // Samples that lie closer than Ω is thick do not have it between them.
    if (!has_surface_ && grid_.voxel <= input_.delta) return a > input_.delta && b > input_.delta;
    return input_.joined(a, b, grid_.voxel);
  }
  template <class Visit> static void for_each_neighbor(std::size_t sample, Visit&& visit) {
    const auto i = static_cast<int>(sample);
    const std::array<int, 3> c{i % n, i / n % n, i / (n * n)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (c[axis] > 0) visit(static_cast<std::size_t>(i - strides[axis]));
      if (c[axis] + 1 < n) visit(static_cast<std::size_t>(i + strides[axis]));
    }
  }
  /// Whether a sample without a side would be given one by its neighbours, did they know it.
  bool is_open(std::size_t brick, std::size_t sample) const {
    const double own = phi(brick, sample);
    bool open = false;
    for_each_neighbor(sample, [&](std::size_t other) { open = open || joined(own, phi(brick, other)); });
    return open;
  }
  void ask_coarse(std::size_t brick);
  void spread(std::size_t brick, std::array<std::uint16_t, DistanceGrid::brick_size>& queue, std::size_t end);
  bool take_from_neighbors(std::size_t brick);
  bool has_open(std::size_t brick);
  void decide_rest(std::size_t brick);
  void sign_bricks();
  void sign_places();

  DistanceGrid& grid_;
  const SidedInput& input_;
  const CoarseSides& coarse_;
  double unit_;
  bool has_surface_;
  std::vector<std::int8_t> sides_;
};

/// Gives what is joined to the queued samples their side.
void BrickSides::spread(std::size_t brick, std::array<std::uint16_t, DistanceGrid::brick_size>& queue,
                        std::size_t end) {
  std::int8_t* sides = of(brick);
  for (std::size_t next = 0; next < end; ++next) {
    const std::size_t sample = queue[next];
    const double own = phi(brick, sample);
    for_each_neighbor(sample, [&](std::size_t other) {
      if (sides[other] != 0 || !joined(own, phi(brick, other))) return;
      sides[other] = sides[sample];
      queue[end++] = static_cast<std::uint16_t>(other);
    });
  }
}

void BrickSides::ask_coarse(std::size_t brick) {
  std::array<std::uint16_t, DistanceGrid::brick_size> order, queue;
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint16_t>(i);
  const std::int16_t* values = grid_.values.data() + brick * DistanceGrid::brick_size;
  // What lies farthest from the input is told first, and tells its neighbours. Most bricks have it at a
  // corner.
  std::size_t tried = 0;
  const auto ask = [&](std::size_t sample) {
    if (of(brick)[sample] != 0) return;
    ++tried;
    const int side = coarse_.side(input_, position(brick, sample), phi(brick, sample));
    if (side == 0) return;
    of(brick)[sample] = static_cast<std::int8_t>(side);
    queue[0] = static_cast<std::uint16_t>(sample);
    spread(brick, queue, 1);
  };
  for (const int z : {0, n - 1})
    for (const int y : {0, n - 1})
      for (const int x : {0, n - 1}) ask(DistanceGrid::sample(x, y, z));
  constexpr std::size_t most_asked = 24;
  if (std::find(of(brick), of(brick) + DistanceGrid::brick_size, 0) == of(brick) + DistanceGrid::brick_size)
    return;
  std::partial_sort(order.begin(), order.begin() + most_asked, order.end(), [&](auto a, auto b) {
    const bool has_a = of(brick)[a] != 0, has_b = of(brick)[b] != 0;
    if (has_a != has_b) return has_b;
    return values[a] != values[b] ? values[a] > values[b] : a < b;
  });
  for (std::size_t i = 0; i < most_asked; ++i)
    if (is_open(brick, order[i])) ask(order[i]);
}

bool BrickSides::has_open(std::size_t brick) {
  for (std::size_t i = 0; i < DistanceGrid::brick_size; ++i)
    if (of(brick)[i] == 0 && is_open(brick, i)) return true;
  return false;
}

/// Of samples that bricks share. Whether there was something to take.
bool BrickSides::take_from_neighbors(std::size_t brick) {
  std::array<std::uint16_t, DistanceGrid::brick_size> queue;
  std::size_t taken = 0;
  const Place own = grid_.at[brick];
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const std::array<int, 3> step{dx, dy, dz};
        Place place = own;
        std::array<int, 3> from{}, to{};
        bool within = dx != 0 || dy != 0 || dz != 0;
        for (std::size_t a = 0; a < 3; ++a) {
          place[a] += step[a];
          within = within && place[a] >= 0 && place[a] < grid_.places[a];
          from[a] = step[a] > 0 ? n - 1 : 0;
          to[a] = step[a] < 0 ? 0 : n - 1;
        }
        if (!within || grid_.index[grid_.place(place)] < 0) continue;
        const std::int8_t* theirs = of(static_cast<std::size_t>(grid_.index[grid_.place(place)]));
        for (int z = from[2]; z <= to[2]; ++z)
          for (int y = from[1]; y <= to[1]; ++y)
            for (int x = from[0]; x <= to[0]; ++x) {
              const std::size_t mine = DistanceGrid::sample(x, y, z);
              const std::int8_t side =
                  theirs[DistanceGrid::sample(x - dx * (n - 1), y - dy * (n - 1), z - dz * (n - 1))];
              if (of(brick)[mine] != 0 || side == 0) continue;
              of(brick)[mine] = side;
              queue[taken++] = static_cast<std::uint16_t>(mine);
            }
      }
  const bool any = taken > 0;
  spread(brick, queue, taken);
  return any;
}

/// Across the input.
void BrickSides::decide_rest(std::size_t brick) {
  std::int8_t* sides = of(brick);
  std::array<std::uint16_t, DistanceGrid::brick_size> queue;
  std::size_t end = 0;
  for (std::size_t i = 0; i < DistanceGrid::brick_size; ++i)
    if (sides[i] != 0) queue[end++] = static_cast<std::uint16_t>(i);
  if (end == DistanceGrid::brick_size) return;
  if (end == 0) {
    const auto farthest = static_cast<std::size_t>(
        std::max_element(grid_.brick(brick).begin(), grid_.brick(brick).end()) - grid_.brick(brick).begin());
    const Vec3 at = position(brick, farthest);
    sides[farthest] =
        static_cast<std::int8_t>(input_.tells_sides() ? input_.sides.label(at) : coarse_.nearest_side(at));
    queue[end++] = static_cast<std::uint16_t>(farthest);
  }
  const auto step_across = [&](std::size_t sample, std::size_t other) {
    if (sides[other] != 0) return;
    sides[other] = static_cast<std::int8_t>(
        input_.sides.label_across(position(brick, sample), sides[sample], position(brick, other)));
    queue[end++] = static_cast<std::uint16_t>(other);
  };
  // What lies on the input tells nobody whether one crosses it: it waits, and spreads nothing.
  const auto is_on_input = [&](std::size_t sample) {
    return has_surface_ && phi(brick, sample) <= 2 * unit_;
  };
  for (std::size_t next = 0; next < end; ++next)
    for_each_neighbor(queue[next], [&](std::size_t other) {
      if (!is_on_input(queue[next]) && !is_on_input(other)) step_across(queue[next], other);
    });
  for (std::size_t sample = 0; input_.tells_sides() && sample < DistanceGrid::brick_size; ++sample) {
    if (sides[sample] != 0 || is_on_input(sample)) continue;
    sides[sample] = static_cast<std::int8_t>(input_.sides.label(position(brick, sample)));
    const std::size_t begin = end;
    queue[end++] = static_cast<std::uint16_t>(sample);
    for (std::size_t next = begin; next < end; ++next)
      for_each_neighbor(queue[next], [&](std::size_t other) {
        if (!is_on_input(other)) step_across(queue[next], other);
      });
  }
  for (std::size_t next = 0; next < end; ++next)
    for_each_neighbor(queue[next], [&](std::size_t other) { step_across(queue[next], other); });
}

void BrickSides::sign_bricks() {
  parallel_for(grid_.values.size(), 1u << 16, [&](std::size_t i) {
    if (sides_[i] < 0) grid_.values[i] = static_cast<std::int16_t>(-grid_.values[i]);
  });
}

/// Empty places are on the side of what they share with a brick, or of an empty neighbour.
void BrickSides::sign_places() {
  constexpr std::int32_t unknown = -3;
  std::vector<std::size_t> queue;
  std::replace(grid_.index.begin(), grid_.index.end(), DistanceGrid::outer, unknown);
  const auto for_each_place_beside = [&](Place place, auto&& visit) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        Place other = place;
        other[axis] += step;
        if (other[axis] >= 0 && other[axis] < grid_.places[axis]) visit(other, axis, step);
      }
  };
  const auto give = [&](Place place, int side) {
    std::int32_t& entry = grid_.index[grid_.place(place)];
    if (entry != unknown) return;
    entry = side < 0 ? DistanceGrid::inner : DistanceGrid::outer;
    queue.push_back(grid_.place(place));
  };
  for (std::size_t brick = 0; brick < grid_.bricks(); ++brick)
    for_each_place_beside(grid_.at[brick], [&](Place other, std::size_t axis, int step) {
      if (grid_.index[grid_.place(other)] != unknown) return;
      // All of the face is on one side, as its place is empty; the middle of it is.
      std::array<int, 3> c{n / 2, n / 2, n / 2};
      c[axis] = step < 0 ? 0 : n - 1;
      give(other, of(brick)[DistanceGrid::sample(c[0], c[1], c[2])]);
    });
  const auto row = static_cast<std::size_t>(grid_.places[0]),
             column = static_cast<std::size_t>(grid_.places[1]);
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::size_t i = queue[next];
    const int side = grid_.index[i] == DistanceGrid::inner ? -1 : 1;
    for_each_place_beside(
        {static_cast<int>(i % row), static_cast<int>(i / row % column), static_cast<int>(i / (row * column))},
        [&](Place other, std::size_t, int) { give(other, side); });
  }
  std::replace(grid_.index.begin(), grid_.index.end(), unknown, DistanceGrid::outer);
}

bool BrickSides::find(const RunControl& control) {
  const std::size_t count = grid_.bricks();
  std::vector<std::uint8_t> open(count, 0);
  parallel_until(count, 16, control, [&](std::size_t i) {
    ask_coarse(i);
    open[i] = has_open(i) ? 1 : 0;
  });
  if (control.cancelled()) return false;
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < count; ++i)
    if (open[i] != 0) waiting.push_back(i);
  for (bool more = true; more && !waiting.empty();) {
    if (control.cancelled()) return false;
    more = false;
    std::erase_if(waiting, [&](std::size_t i) {
      if (!take_from_neighbors(i)) return false;
      more = true;
      return !has_open(i);
    });
  }
  parallel_until(count, 16, control, [&](std::size_t i) { decide_rest(i); });
  if (control.cancelled()) return false;
  sign_bricks();
  sign_places();
  return true;
}

} // namespace

Status find_sides(DistanceGrid& grid, const SidedInput& input, const RunControl& control) {
  const double longest = grid.box.longest_edge();
  const double spacing = std::max(longest / coarse_points, 0.5 * DistanceGrid::cells * grid.voxel);
  auto coarse = CoarseSides::find(input, grid.box, spacing, control);
  if (!coarse) return coarse.error();
  if (!BrickSides(grid, input, *coarse).find(control))
    return Error{ErrorCode::cancelled, "The picture of the tolerance volume was cancelled.", ""};
  grid.has_sides = true;
  return {};
}

} // namespace isoscope
