// Makes cells and asks them.
#include "tolerance/nearest_cells.h"

#include "base/scramble.h"
#include "tolerance/box_search.h"

#include <algorithm>
#include <limits>
#include <new>

namespace isoscope {
namespace {

constexpr std::size_t bucket_count = std::size_t{1} << 18;
/// Cells with more triangles are divided, up to this often; then the hierarchy is as fast.
constexpr std::size_t most_listed = 48;
constexpr unsigned most_levels = 3;
/// Around the input's box, in sides; points farther out are looked up in the index.
constexpr double apron = 8;
constexpr double most_along_axis = 1 << 17; ///< along an axis: three levels fit into the bits of a key
/// Triangles next to the nearest that others are compared to, to leave these out.
constexpr std::size_t rival_count = 6;
/// Sizes of cells within which floats, and some 1e6 times less or more, are far from their ends.
constexpr double least_side = 1e-20, largest_side = 1e20;
/// Of the lengths that a float bound is made of: more than its few roundings.
constexpr double float_margin = 1e-6;

using Corners = std::array<Vec3, 8>;

/// A lower bound of the distance to a triangle, linear in the offset from a cell's centre: distances to
/// convex sets are convex.
struct Bound {
  double distance;
  Vec3 direction;
  std::uint32_t slot;
};

} // namespace

/// Bounds of four triangles.
struct NearestCells::Group {
  Lanes distance, x, y, z;
  std::uint32_t slot[4];
};

/// A cell: a header with its groups behind it.
struct alignas(16) NearestCells::Cell {
  enum class Kind : std::uint32_t { lists, divided, crowded };
  std::uint64_t key;
  Cell* next;
  Kind kind;
  std::uint32_t group_count;

  const Group* groups() const { return reinterpret_cast<const Group*>(this + 1); }
};

/// A cell by its level and its place in that level's lattice.
struct NearestCells::Place {
  unsigned level;
  Vec3 center;
  double half_side;
  std::uint64_t key;
};

NearestCells::NearestCells(const ClosestPointIndex& index, double side, std::size_t byte_limit)
    : index_(&index), lo_(index.bounds().lo), side_(side), byte_limit_(byte_limit), buckets_(bucket_count) {
  if (index.empty()) return;
  side_ = std::max(side, index.bounds().longest_edge() / (most_along_axis - 2 * apron - 1));
  if (!(side_ >= least_side && side_ <= largest_side)) return; // no cell holds any point
  inverse_side_ = 1 / side_;
  double largest = 0;
  for (int a = 0; a < 3; ++a) {
    lo_[a] -= apron * side_;
    cells_[a] = std::ceil((index.bounds().hi[a] - lo_[a]) * inverse_side_ + apron);
    largest = std::max({largest, std::abs(index.bounds().lo[a]), std::abs(index.bounds().hi[a])});
  }
  rounding_ = 1e-13 * (largest + apron * side_);
}

NearestCells::~NearestCells() {
  for (std::atomic<Cell*>& bucket : buckets_)
    for (Cell* cell = bucket.load(std::memory_order_relaxed); cell != nullptr;) {
      Cell* next = cell->next;
      ::operator delete (cell, std::align_val_t{alignof(Group)});
      cell = next;
    }
}

const NearestCells::Cell* NearestCells::find(Vec3 p, Vec3& step) const {
  const Vec3 at = inverse_side_ * (p - lo_);
  for (int a = 0; a < 3; ++a)
    if (!(at[a] >= 0 && at[a] < cells_[a])) return nullptr;
  double parts = 1, side = side_;
  for (unsigned level = 0; level < most_levels; ++level, parts *= 2, side *= 0.5) {
    std::uint64_t key = level, block = level, corner = 0;
    Vec3 center;
    for (int a = 0; a < 3; ++a) {
      const auto cell = static_cast<std::int32_t>(at[a] * parts);
      const auto i = static_cast<std::uint64_t>(cell);
      key = key << 20 | i;
      block = block << 20 | i >> 1;
      corner = corner << 1 | (i & 1);
      center[a] = lo_[a] + (cell + 0.5) * side;
    }
    std::atomic<Cell*>& bucket = buckets_[(scrambled(block) << 3 | corner) % bucket_count];
    const Cell* cell = bucket.load(std::memory_order_acquire);
    while (cell != nullptr && cell->key != key) cell = cell->next;
    if (cell == nullptr) cell = made({level, center, 0.5 * side, key}, bucket);
    if (cell == nullptr || cell->kind == Cell::Kind::crowded) return nullptr;
    if (cell->kind == Cell::Kind::divided) continue;
    step = p - center;
    return cell;
  }
  return nullptr;
}

const NearestCells::Cell* NearestCells::made(const Place& place, std::atomic<Cell*>& bucket) const {
  if (bytes_.load(std::memory_order_relaxed) > byte_limit_) return nullptr;
  std::vector<Group> groups = triangles_of(place.center, place.half_side);
  const bool crowded = 4 * groups.size() > most_listed;
  if (crowded) groups.clear();
  const std::size_t size = sizeof(Cell) + groups.size() * sizeof(Group);
  void* memory = ::operator new (size, std::align_val_t{alignof(Group)});
  Cell* cell =
      new (memory) Cell{place.key, nullptr, Cell::Kind::lists, static_cast<std::uint32_t>(groups.size())};
  if (crowded) cell->kind = place.level + 1 < most_levels ? Cell::Kind::divided : Cell::Kind::crowded;
  std::uninitialized_copy(groups.begin(), groups.end(), reinterpret_cast<Group*>(cell + 1));
  cell->next = bucket.load(std::memory_order_acquire);
  while (!bucket.compare_exchange_weak(cell->next, cell, std::memory_order_release,
                                       std::memory_order_acquire)) {}
  bytes_.fetch_add(size, std::memory_order_relaxed);
  return cell;
}

std::vector<NearestCells::Group> NearestCells::triangles_of(Vec3 center, double half_side) const {
  Corners corners;
  for (std::size_t k = 0; k < corners.size(); ++k)
    corners[k] = half_side * Vec3{k & 1 ? 1. : -1., k & 2 ? 1. : -1., k & 4 ? 1. : -1.};
  const auto at_corners = [&](std::uint32_t slot) {
    std::array<double, 8> distances;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec3 p = center + corners[k];
      distances[k] = length(closest_point_on_triangle(p, index_->triangle_at(slot)) - p);
    }
    return distances;
  };
  // Distances to one triangle are convex: within the cell none exceeds the largest at its corners.
  const std::uint32_t nearest = index_->slot_of(index_->closest(center).triangle);
  const std::array<double, 8> of_nearest = at_corners(nearest);
  const double reach = *std::max_element(of_nearest.begin(), of_nearest.end());
  const double margin = float_margin * (reach + half_side) + rounding_;
  Box3 box{center, center};
  box = box.grown(half_side);
  std::vector<Bound> bounds;
  for (const std::uint32_t slot : index_->slots_within(box, reach + margin)) {
    const Vec3 away = center - closest_point_on_triangle(center, index_->triangle_at(slot));
    const double d = length(away);
    // So near to it the direction means nothing.
    if (d < 1e6 * rounding_)
      bounds.push_back({0, {}, slot});
    else
      bounds.push_back({d, away / d, slot});
  }
  std::sort(bounds.begin(), bounds.end(), [](const Bound& a, const Bound& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.slot < b.slot;
  });
  // Where a triangle's bound is above the distance to another at all corners it is so in all of the cell.
  const auto leave_out = [&](std::uint32_t rival, const std::array<double, 8>& distances) {
    std::erase_if(bounds, [&](const Bound& b) {
      if (b.slot == rival || b.distance == 0) return false;
      for (std::size_t k = 0; k < corners.size(); ++k)
        if (b.distance + dot(b.direction, corners[k]) < distances[k] + margin) return false;
      return true;
    });
  };
  leave_out(nearest, of_nearest);
  for (std::size_t i = 0; i < std::min(bounds.size(), rival_count); ++i)
    leave_out(bounds[i].slot, at_corners(bounds[i].slot));

  std::vector<Group> groups((bounds.size() + 3) / 4);
  for (std::size_t i = 0; i < 4 * groups.size(); ++i) {
    Group& g = groups[i / 4];
    const std::size_t k = i % 4;
    const Bound b = i < bounds.size() ? bounds[i] : Bound{1e30, {}, 0};
    const double d =
        b.distance == 0 ? -1e30 : b.distance - float_margin * (b.distance + 2 * half_side) - rounding_;
    g.distance[k] = static_cast<float>(d);
    g.x[k] = static_cast<float>(b.direction.x);
    g.y[k] = static_cast<float>(b.direction.y);
    g.z[k] = static_cast<float>(b.direction.z);
    g.slot[k] = b.slot;
  }
  return groups;
}

ClosestPoint NearestCells::from_cell(Vec3 p, const ClosestPoint& found) const {
  Vec3 step;
  const Cell* cell = index_->empty() ? nullptr : find(p, step);
  if (cell == nullptr) return index_->nearest_from(p, found);
  const auto x = static_cast<float>(step.x), y = static_cast<float>(step.y), z = static_cast<float>(step.z);
  const Group* const groups = cell->groups();
  const std::uint32_t count = cell->group_count;
  std::array<Lanes, most_listed / 4> bounds;
  Lanes least = groups[0].distance + x * groups[0].x + y * groups[0].y + z * groups[0].z;
  bounds[0] = least;
  for (std::uint32_t g = 1; g < count; ++g) {
    bounds[g] = groups[g].distance + x * groups[g].x + y * groups[g].y + z * groups[g].z;
    least = bounds[g] < least ? bounds[g] : least;
  }
  ClosestPoint best = found;
  // What is known already is not asked again.
  const std::uint32_t known =
      found.triangle.valid() ? index_->slot_of(found.triangle) : std::numeric_limits<std::uint32_t>::max();
  // The triangle with the least bound is the nearest, mostly; then few others can be nearer.
  float limit = std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
  const auto limit_of_best = [&] { return static_cast<float>(best.distance()); };
  const auto look_at = [&](std::uint32_t slot) {
    if (slot == known) return;
    const Vec3 c = closest_point_on_triangle(p, index_->triangle_at(slot));
    const double d2 = squared_length(c - p);
    if (d2 > best.squared_distance) return;
    const TriangleId id = index_->id_at(slot);
    if (d2 == best.squared_distance && best.triangle.valid() && best.triangle < id) return;
    best = {c, d2, id};
    limit = limit_of_best();
  };
  if (known != std::numeric_limits<std::uint32_t>::max() && limit > limit_of_best()) return best;
  std::uint32_t first = 0;
  const auto up_to_limit = [&](std::uint32_t g) {
    return std::bit_cast<std::array<std::int32_t, 4>>(bounds[g] <= limit);
  };
  const auto any = [](const std::array<std::int32_t, 4>& lanes) {
    return (lanes[0] | lanes[1] | lanes[2] | lanes[3]) != 0;
  };
  while (!any(up_to_limit(first))) ++first;
  const auto is_least = up_to_limit(first);
  const std::size_t lane = is_least[0] != 0 ? 0 : is_least[1] != 0 ? 1 : is_least[2] != 0 ? 2 : 3;
  look_at(groups[first].slot[lane]);
  limit = limit_of_best();
  bounds[first][lane] = std::numeric_limits<float>::max();
  for (std::uint32_t g = 0; g < count; ++g) {
    if (!any(up_to_limit(g))) continue;
    for (std::size_t k = 0; k < 4; ++k)
      if (bounds[g][k] <= limit) look_at(groups[g].slot[k]);
  }
  return best;
}

} // namespace isoscope
