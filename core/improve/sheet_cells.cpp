// A table with open addressing; facets larger than a few cells are cut before they are entered.
#include "improve/sheet_cells.h"

#include "base/halves.h"
#include "base/scramble.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {
namespace {

/// Of a facet's normal and a direction.
constexpr double least_cosine_to_direction = 0.1;
/// Of twice the area to the square of the longest edge: below this rounding might turn a normal.
constexpr double least_width = 1e-9;
/// Places of cells have so many bits an axis.
constexpr int place_bits = 21;
constexpr std::int64_t largest_place = (std::int64_t{1} << (place_bits - 1)) - 4;
/// Facets whose boxes span more cells along an axis are cut.
constexpr std::int64_t widest_span = 3;
/// Of a cell's side: what parts of facets may be off by, and much more.
constexpr double rounding_of_parts = 1.0 / 1024;
constexpr std::size_t first_slots = 1024;

/// The 13 of which the others are the opposites.
constexpr std::array<Vec3, 13> axes{{{1, 0, 0},
                                     {0, 1, 0},
                                     {0, 0, 1},
                                     {1, 1, 0},
                                     {1, -1, 0},
                                     {1, 0, 1},
                                     {1, 0, -1},
                                     {0, 1, 1},
                                     {0, 1, -1},
                                     {1, 1, 1},
                                     {1, 1, -1},
                                     {1, -1, 1},
                                     {-1, 1, 1}}};

std::uint64_t key_of(std::int64_t x, std::int64_t y, std::int64_t z) {
  constexpr std::uint64_t mask = (std::uint64_t{1} << place_bits) - 1;
  return (static_cast<std::uint64_t>(x) & mask) << (2 * place_bits) |
         (static_cast<std::uint64_t>(y) & mask) << place_bits | (static_cast<std::uint64_t>(z) & mask);
}

/// Calls take(key) for all cells of a range until it returns false; whether it never did.
template <class Take> bool each_cell(const CellRange& r, const Take& take) {
  for (std::int64_t x = r.lo[0]; x <= r.hi[0]; ++x)
    for (std::int64_t y = r.lo[1]; y <= r.hi[1]; ++y)
      for (std::int64_t z = r.lo[2]; z <= r.hi[2]; ++z)
        if (!take(key_of(x, y, z))) return false;
  return true;
}

} // namespace

DirectionSet directions_of(const Triangle3& t) {
  const Vec3 n = area_vector(t);
  const double squared = squared_length(n);
  const double longest =
      std::max({squared_length(t[1] - t[0]), squared_length(t[2] - t[1]), squared_length(t[0] - t[2])});
  if (!(squared > least_width * least_width * longest * longest)) return 0;
  DirectionSet set = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double along = dot(n, axes[i]);
    const double square = along * along;
    if (square > least_cosine_to_direction * least_cosine_to_direction * squared_length(axes[i]) * squared)
      set |= DirectionSet{1} << (2 * i + (along < 0 ? 1 : 0));
  }
  return set;
}

bool SheetCells::fits(const Box3& box) const {
  for (int a = 0; a < 3; ++a)
    if (!(std::abs(box.lo[a]) < largest_place * side_) || !(std::abs(box.hi[a]) < largest_place * side_))
      return false;
  return true;
}

CellRange SheetCells::range(const Box3& box) const {
  CellRange r{};
  for (int a = 0; a < 3; ++a) {
    const auto k = static_cast<std::size_t>(a);
    r.lo[k] = static_cast<std::int64_t>(std::floor(box.lo[a] / side_));
    r.hi[k] = static_cast<std::int64_t>(std::floor(box.hi[a] / side_));
  }
  return r;
}

std::size_t SheetCells::slot_of(std::uint64_t key) const {
  std::size_t i = scrambled(key) & (slots_.size() - 1);
  while (slots_[i].key != key && slots_[i].key != no_key) i = (i + 1) & (slots_.size() - 1);
  return i;
}

void SheetCells::grow() {
  std::vector<Slot> before(std::max(first_slots, 2 * slots_.size()));
  before.swap(slots_);
  for (const Slot& slot : before)
    if (slot.key != no_key) slots_[slot_of(slot.key)] = slot;
}

void SheetCells::add(const CellRange& r) {
  each_cell(r, [&](std::uint64_t key) {
    if (2 * known_ >= slots_.size()) grow();
    Slot& slot = slots_[slot_of(key)];
    if (slot.key == no_key) slot = {key, all_directions}, ++known_;
    return true;
  });
}

void SheetCells::restrict(const CellRange& r, DirectionSet directions) {
  if (slots_.empty()) return;
  each_cell(r, [&](std::uint64_t key) {
    Slot& slot = slots_[slot_of(key)];
    if (slot.key == key) slot.directions &= directions;
    return true;
  });
}

void SheetCells::restrict(const Triangle3& facet) {
  const DirectionSet directions = directions_of(facet);
  std::vector<Triangle3> open{facet};
  bool cut = false;
  while (!open.empty()) {
    const Triangle3 t = open.back();
    open.pop_back();
    const CellRange r = range(cut ? box_of(t).grown(rounding_of_parts * side_) : box_of(t));
    if (r.hi[0] - r.lo[0] < widest_span && r.hi[1] - r.lo[1] < widest_span &&
        r.hi[2] - r.lo[2] < widest_span) {
      restrict(r, directions);
      continue;
    }
    cut = true;
    for (const Triangle3& half : halves(t)) open.push_back(half);
  }
}

DirectionSet SheetCells::common(const CellRange& r) const {
  if (slots_.empty()) return 0;
  DirectionSet set = all_directions;
  const auto take = [&](std::uint64_t key) {
    const Slot& slot = slots_[slot_of(key)];
    set &= slot.key == key ? slot.directions : 0;
    return set != 0;
  };
  return each_cell(r, take) ? set : 0;
}

} // namespace isoscope
