// Cells of space with the directions along which a surface in them is seen from its front alone: there it is
// a graph, whatever else it is elsewhere (core/README.md, N10).
#pragma once

#include "base/geometry.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

/// A set of directions, one bit each, out of the 26 to the neighbours of a cube.
using DirectionSet = std::uint32_t;
constexpr DirectionSet all_directions = (DirectionSet{1} << 26) - 1;
/// The directions in which a facet looks, by a margin that no rounding reaches; none where it is a needle.
DirectionSet directions_of(const Triangle3& facet);
/// Places of cells, with both ends.
struct CellRange {
  std::array<std::int64_t, 3> lo, hi;
};

/// Half-open cubic cells, of which those that were asked for know the directions in which all facets that
/// meet them look.
class SheetCells {
 public:
  /// `side`: a power of two, so that places are exact.
  explicit SheetCells(double side) : side_(side) {}

  /// Whether places in a box can be told from each other.
  bool fits(const Box3& box) const;
  CellRange range(const Box3& box) const;
  /// Makes the cells of a range known, with all directions.
  void add(const CellRange& range);
  /// Leaves the known cells of a range these directions alone.
  void restrict(const CellRange& range, DirectionSet directions);
  /// The same for those that a facet may meet, also a large one.
  void restrict(const Triangle3& facet);
  /// The directions that all cells of a range have; none where one is not known.
  DirectionSet common(const CellRange& range) const;

 private:
  static constexpr std::uint64_t no_key = ~std::uint64_t{0};
  struct Slot {
    std::uint64_t key = no_key;
    DirectionSet directions = 0;
  };
  std::size_t slot_of(std::uint64_t key) const;
  void grow();

  double side_;
  std::size_t known_ = 0;
  std::vector<Slot> slots_; ///< a power of two of them, probed one by one
};

} // namespace isoscope
