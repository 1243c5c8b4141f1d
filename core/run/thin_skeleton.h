// Ways inside of what is thinner than twice the tolerance: from where a side still has its region out into
// walls and gaps of which Ω leaves nothing.
#pragma once

#include "run/input_walls.h"
#include "run/lattice_cell.h"
#include "tolerance/tolerance_volume.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace isoscope {

/// A forest over the middles of thin parts of one side. Its nodes stand for the cells of a lattice that the
/// input meets; roots are where a ball of radius δ' fits between the walls.
class ThinSkeleton {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  struct Node {
    Vec3 middle; ///< of the largest ball of the side that touches the input there, of radius δ' at most
    bool usable = false; ///< the wall bounds the side
    bool root = false;
    bool end = false; ///< a root of those that no region is reached from
    double way =
        Box3::inf; ///< to the nearest root along the forest, absolute; infinite where none is reached
    std::uint32_t parent = none;
    bool straight = false; ///< whether nothing of the input lies between its middle and that of its parent
  };

  /// Grows from the places `from` and `ends`, points of the input, over walls of the side `label` (-1 in the
  /// inside of walls, +1 in gaps) as far as they are thin. Where no region is reached from an end, it is a
  /// root itself, once for all that it reaches. Incomplete once the control is cancelled.
  ThinSkeleton(const ToleranceVolume& volume, const InputWalls& walls, int label, std::span<const Vec3> from,
               std::span<const Vec3> ends, const RunControl& control);

  std::span<const Node> nodes() const { return nodes_; }
  /// The node of the cell that holds p; none where there is none of use.
  std::uint32_t node_at(Vec3 p) const;

 private:
  using Cell = LatticeCell;

  const ToleranceVolume& volume_;
  const InputWalls& walls_;
  int label_;
  double side_; ///< of the lattice's cells
  Vec3 origin_;
  std::map<Cell, std::uint32_t> cells_;
  std::vector<Node> nodes_;
  std::vector<Cell> cell_of_; ///< by node

  Cell cell_at(Vec3 p) const { return lattice_cell(p, origin_, side_); }
  Node make_node(const Cell& cell) const;
  /// The cells of these places, of a lattice that is coarse enough for them.
  std::vector<Cell> start(std::span<const Vec3> from);
  void grow(std::span<const Vec3> from, const RunControl& control);
  bool strays(Vec3 a, Vec3 b) const;
  void find_ways(std::span<const Vec3> ends, const RunControl& control);
  void spread(std::vector<std::uint32_t> roots, const RunControl& control);
};

} // namespace isoscope
