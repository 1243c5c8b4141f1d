// An octree of φ whose cells are small where φ is, and which of its leaves touch.
#pragma once

#include "base/geometry.h"
#include "base/run_control.h"
#include "tolerance/cell_links.h"
#include "tolerance/field.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isoscope {

/// Leaves are smaller than φ at their centres by a factor, but not much smaller than `finest` by that factor.
class FieldOctree {
 public:
  /// Of no use once the control is cancelled.
  FieldOctree(const ToleranceField& field, double finest, const RunControl& control);

  bool empty() const { return leaves_.empty(); }
  /// φ at the centres of the leaves.
  std::vector<double> values() const;
  Vec3 center(std::uint32_t leaf) const { return center(cells_[leaves_[leaf]]); }
  /// Each two leaves with a common face.
  std::vector<CellLink> links() const;
  /// The leaves at the border of the octree, which is outside of everything.
  std::vector<std::uint32_t> border() const;

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  /// A cube: position in units of its side, which is the octree's divided by 2^level.
  struct Cell {
    std::array<std::uint32_t, 3> position{};
    std::uint32_t child = none; ///< first of eight consecutive children; of a leaf: none
    std::uint32_t leaf = none;  ///< its number among the leaves
    TriangleId site;
    float value = 0;
    std::uint8_t level = 0;
  };

  double side(unsigned level) const { return side_ / static_cast<double>(std::uint64_t{1} << level); }
  Vec3 center(const Cell& c) const;
  /// The cell of the same or a coarser level across a face; none at the border. Face 2a + s is the side s of
  /// axis a.
  std::uint32_t neighbor(const Cell& c, unsigned face) const;

  Vec3 origin_;
  double side_ = 0;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> leaves_; ///< cells, ascending
};

} // namespace isoscope
