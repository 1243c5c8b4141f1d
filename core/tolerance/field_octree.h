// An octree of φ whose cells are small where φ is, and which of its leaves touch.
#pragma once

#include "base/geometry.h"
#include "base/run_control.h"
#include "tolerance/field.h"

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace isoscope {

/// Leaves are smaller than φ at their centres by a factor, but not much smaller than `finest` by that factor.
class FieldOctree {
 public:
  /// Of no use once the control is cancelled.
  FieldOctree(const ToleranceField& field, double finest, const RunControl& control);

  bool empty() const { return leaves_.empty(); }
  std::size_t leaves() const { return leaves_.size(); }
  /// φ at the centre of a leaf.
  double value(std::uint32_t leaf) const { return static_cast<double>(cells_[leaves_[leaf]].value); }
  Vec3 center(std::uint32_t leaf) const { return center(cells_[leaves_[leaf]]); }
  /// Calls visit(leaf) for the leaves that have a face in common with a leaf, in a defined order. Returns
  /// whether it lies at the border of the octree, which is outside of everything.
  template <class Visit> bool for_each_neighbor(std::uint32_t leaf, const Visit& visit) const {
    bool at_border = false;
    for (unsigned face = 0; face < 6; ++face) {
      const std::uint32_t other = neighbor(leaves_[leaf], face);
      if (other == none)
        at_border = true;
      else
        visit_at_face(other, face ^ 1u, visit);
    }
    return at_border;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  static constexpr std::uint32_t leaf_bit = 0x80000000u;
  /// A cube. There are millions, so it is kept small.
  struct Cell {
    /// The path from the root, three bits a level (x, y, z from the lowest), behind a leading 1.
    std::uint64_t path = 1;
    /// The first of eight consecutive children, or leaf_bit and its number among the leaves.
    std::uint32_t next = leaf_bit;
    float value = 0;
    bool is_leaf() const { return (next & leaf_bit) != 0; }
    unsigned level() const { return (static_cast<unsigned>(std::bit_width(path)) - 1) / 3; }
    /// Its position in units of its side, which is the octree's divided by 2^level.
    std::array<std::uint32_t, 3> position() const;
  };

  double side(unsigned level) const { return side_ / static_cast<double>(std::uint64_t{1} << level); }
  Vec3 center(const Cell& c) const;
  /// The cell of the same or a coarser level across a face; none at the border. Face 2a + s is the side s of
  /// axis a.
  std::uint32_t neighbor(std::uint32_t cell, unsigned face) const;
  template <class Visit> void visit_at_face(std::uint32_t cell, unsigned face, const Visit& visit) const {
    const Cell& c = cells_[cell];
    if (c.is_leaf()) return visit(c.next & ~leaf_bit);
    for (std::uint32_t k = 0; k < 8; ++k)
      if ((k >> face / 2 & 1u) == (face & 1u)) visit_at_face(c.next + k, face, visit);
  }

  Vec3 origin_;
  double side_ = 0;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> leaves_; ///< cells, ascending
};

} // namespace isoscope
