// How many connected pieces a surface on a lattice has, from its vertices and what joins them.
#pragma once

#include "base/growing_array.h"
#include "base/run_control.h"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

/// The pieces of the surface that marching tetrahedra make, a bounded number of cells at a time.
class SurfacePieces {
 public:
  /// A lattice cell by its place, in cells.
  using Place = std::array<std::uint32_t, 3>;

  /// The vertex of the surface on the lattice's edge between two corners of a cell (bits by axis), of which
  /// `outer` is the one that is behind the boundary.
  static std::uint64_t vertex(const Place& cell, unsigned outer, unsigned inner) {
    const unsigned low = outer & inner, direction = outer ^ inner;
    const auto coordinate = [&](unsigned axis) { return std::uint64_t{cell[axis]} + ((low >> axis) & 1u); };
    return (std::uint64_t{outer != low} << 3 | direction) << (3 * key_bits) |
           coordinate(2) << (2 * key_bits) | coordinate(1) << key_bits | coordinate(0);
  }
  /// Whether places at a level of an octree fit into what a vertex is told by.
  static bool fits(unsigned level) { return level < key_bits; }

  void add(std::uint64_t vertex, std::uint16_t component) { recent_.push_back({vertex, component}); }
  void join(std::uint64_t a, std::uint64_t b) { recent_links_.push_back({a, b}); }

  /// Those of other cells, settled.
  void add(const SurfacePieces& others);
  /// After some cells: what they have joined is a group from now on. Links are kept to vertices of other
  /// cells alone, before or after these.
  void settle();
  /// Of each boundary component; of no use once the control is cancelled.
  std::vector<std::size_t> count(std::size_t components, const RunControl& control);

 private:
  struct Vertex {
    std::uint64_t key;
    std::uint16_t component;
    friend auto operator<=>(const Vertex&, const Vertex&) = default;
  };
  using Link = std::array<std::uint64_t, 2>;

  /// A vertex of some cells, with what they have joined it to. There are millions.
  struct Settled {
    std::uint64_t key;
    std::uint32_t group;
    std::uint16_t component;
  };

  static constexpr unsigned key_bits = 20;
  std::vector<Vertex> recent_;
  std::vector<Link> recent_links_;
  GrowingArray<Settled> settled_;
  GrowingArray<Link> links_;
  std::uint32_t groups_ = 0;
};

} // namespace isoscope
