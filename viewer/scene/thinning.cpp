// An order of samples in which every prefix is spread evenly over the surface.
#include "scene/thinning.h"

#include <algorithm>
#include <bit>

namespace isoscope {
namespace {

constexpr int octree_levels = 20;

/// Interleaves 20 bits with two zeros between neighbours.
std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | (x << 32)) & 0x1f00000000ffffull;
  x = (x | (x << 16)) & 0x1f0000ff0000ffull;
  x = (x | (x << 8)) & 0x100f00f00f00f00full;
  x = (x | (x << 4)) & 0x10c30c30c30c30c3ull;
  return (x | (x << 2)) & 0x1249249249249249ull;
}

std::uint32_t reversed_bits(std::uint32_t x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  return (x >> 16) | (x << 16);
}

} // namespace

std::vector<std::uint32_t> thinning_order(std::span<const Vec3> positions,
                                          std::span<const std::int8_t> labels) {
  struct Entry {
    std::uint64_t key; // path in the octree below the label
    std::uint32_t id, scattered;
    int level;
  };
  Box3 box;
  for (const Vec3 p : positions) box.add(p);
  const double scale = ((1 << octree_levels) - 1) / std::max(box.longest_edge(), 1e-300);
  std::vector<Entry> entries(positions.size());
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    const Vec3 q = scale * (positions[i] - box.lo);
    std::uint64_t key = labels[i] > 0 ? 1ull << 62 : 0;
    for (int axis = 0; axis < 3; ++axis) key |= spread_bits(static_cast<std::uint64_t>(q[axis])) << axis;
    entries[i] = {key, i, reversed_bits(i), 0};
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.id < b.id; });
  // The first entry of a cell stands for it: as many levels as it shares with its predecessor already have
  // theirs.
  for (std::size_t i = 1; i < entries.size(); ++i)
    entries[i].level = std::countl_zero(entries[i].key ^ entries[i - 1].key);
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    const int la = a.level / 3, lb = b.level / 3; // three bits of the key are one level
    return la != lb ? la < lb : (a.scattered != b.scattered ? a.scattered < b.scattered : a.id < b.id);
  });
  std::vector<std::uint32_t> order(entries.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = entries[i].id;
  return order;
}

} // namespace isoscope
