// A growing hash grid of points: which samples lie near a box.
#pragma once

#include "base/geometry.h"
#include "base/growing_array.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

/// Holds indices of points by the grid cell they lie in. At most some 25 bytes a point.
class SampleGrid {
 public:
  /// `side` of the grid's cells; points lie within 2^20 cells of `origin` in each direction.
  SampleGrid(Vec3 origin, double side);

  /// Adds the next point; its index is the number of points added before.
  void add(Vec3 p);
  /// Appends the indices of all points in cells that meet `box`, in an order that depends on what was added
  /// only.
  void gather(const Box3& box, std::vector<std::uint32_t>& found) const;
  std::size_t memory_bytes() const {
    return keys_.size() * sizeof(std::uint64_t) +
           (slots_.size() + last_.size() + next_.size()) * sizeof(std::uint32_t);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  std::int64_t coordinate(double x, double origin) const;
  std::size_t find(std::uint64_t key) const;
  void grow();

  Vec3 origin_;
  double side_;
  /// Numbers of cells that have points; open addressing, a power of two of them, at most half of them taken.
  std::vector<std::uint32_t> slots_;
  GrowingArray<std::uint64_t> keys_; ///< by cell
  GrowingArray<std::uint32_t> last_; ///< by cell: the point that was added last
  GrowingArray<std::uint32_t> next_; ///< by point: the one added to its cell before
};

} // namespace isoscope
