// A loose octree of facets that come and go: who is near a box.
#pragma once

#include "base/geometry.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isoscope {

/// Each facet lies in the cell of its box's centre on the deepest level whose side is at least the box's
/// longest edge; it sticks out of its cell by half a side at most.
class FacetOctree {
 public:
  /// Centres of all boxes must lie in `domain`.
  explicit FacetOctree(const Box3& domain);
  void insert(std::uint32_t facet, const Box3& box);
  /// Takes a facet out; `box` must be the one it was inserted with.
  void erase(std::uint32_t facet, const Box3& box);
  /// Calls visit(facet) for every facet whose cell reaches `box`, until it returns true. Thread-safe. The
  /// order depends on the sequence of insertions only.
  template <class Visit> bool visit(const Box3& box, const Visit& visit) const {
    return visit_cell(0, origin_, side_, box, visit);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  static constexpr int most_levels = 20;
  struct Cell {
    std::array<std::uint32_t, 8> children{none, none, none, none, none, none, none, none};
    std::vector<std::uint32_t> facets;
    std::uint32_t count = 0; ///< facets in the subtree
  };

  /// Calls at(cell) on the way from the root to the cell of `box`, making the cells that are missing.
  template <class At> void descend(const Box3& box, const At& at);
  template <class Visit>
  bool visit_cell(std::uint32_t index, Vec3 corner, double side, const Box3& box, const Visit& visit) const;

  Vec3 origin_;
  double side_;
  std::vector<Cell> cells_;
};

template <class Visit>
bool FacetOctree::visit_cell(std::uint32_t index, Vec3 corner, double side, const Box3& box,
                             const Visit& visit) const {
  const Cell& cell = cells_[index];
  if (cell.count == 0) return false;
  for (int k = 0; k < 3; ++k)
    if (box.hi[k] < corner[k] - 0.51 * side || box.lo[k] > corner[k] + 1.51 * side) return false;
  for (const std::uint32_t f : cell.facets)
    if (visit(f)) return true;
  for (std::size_t c = 0; c < 8; ++c) {
    if (cell.children[c] == none) continue;
    const double half = side / 2;
    const Vec3 at{corner.x + (c & 1u ? half : 0), corner.y + (c & 2u ? half : 0),
                  corner.z + (c & 4u ? half : 0)};
    if (visit_cell(cell.children[c], at, half, box, visit)) return true;
  }
  return false;
}

} // namespace isoscope
