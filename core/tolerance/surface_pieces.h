// How many connected pieces a surface on a lattice has, from its vertices and what joins them.
#pragma once

#include "base/growing_array.h"
#include "base/run_control.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace isoscope {

/// The pieces of the surface that marching tetrahedra make, from those within blocks of cells.
class SurfacePieces {
 public:
  /// A lattice point, in cells.
  using Place = std::array<std::uint32_t, 3>;

  /// Whether places at a level of an octree fit into what a vertex is told by.
  static bool fits(unsigned level) { return level < place_bits; }

  /// Those of other cells.
  void add(const SurfacePieces& others);
  /// Of each boundary component; of no use once the control is cancelled.
  std::vector<std::size_t> count(std::size_t components, const RunControl& control);

 private:
  friend class PiecesOfBlock;
  using Link = std::array<std::uint64_t, 2>;

  /// A vertex that other blocks may have links to, with what its own block has joined it to.
  struct Shared {
    std::uint64_t key;
    std::uint32_t group;
  };

  static constexpr unsigned place_bits = 20;
  GrowingArray<Shared> shared_;
  GrowingArray<Link> links_; ///< to vertices of other blocks
  std::vector<std::pair<std::uint16_t, std::uint32_t>> groups_by_component_;
  std::uint32_t groups_ = 0;
};

/// The pieces within some cells, whose corners are numbered.
class PiecesOfBlock {
 public:
  explicit PiecesOfBlock(std::size_t corners) : node_(slots_at_corner * corners, none), cells_(corners, 0) {}

  /// The vertex of the surface on an edge of the lattice: that edge's low end, by number, where it leads
  /// (bits by axis, 1 to 7), and whether its low end is behind the boundary or its other one.
  using Vertex = std::uint32_t;
  static Vertex vertex(std::uint32_t low, unsigned direction, bool low_is_outer) {
    return slots_at_corner * low + 2 * (direction - 1) + (low_is_outer ? 1 : 0);
  }

  /// One of the cells has this corner; told once for each cell.
  void see(std::uint32_t corner) { ++cells_[corner]; }
  /// Of a boundary component.
  void add(Vertex v, std::uint16_t component);
  /// Of no effect where one of the two is added nowhere.
  void join(Vertex a, Vertex b) { links_.push_back({a, b}); }
  /// After all cells, each of which stands in one block.
  SurfacePieces settled(const std::function<SurfacePieces::Place(std::uint32_t corner)>& place_of) const;

 private:
  static constexpr std::uint32_t slots_at_corner = 14, none = ~std::uint32_t{0};
  static constexpr std::uint8_t cells_at_corner = 8;

  struct Node {
    Vertex vertex;
    std::uint16_t component;
  };
  std::vector<std::uint32_t> node_; ///< by vertex: its node, or none
  std::vector<Node> nodes_;
  std::vector<std::array<Vertex, 2>> links_;
  std::vector<std::uint8_t> cells_; ///< by corner: how many have it
};

} // namespace isoscope
