// A triangle mesh by its corners and what lies opposite to them: two words a corner, for surfaces of millions
// of facets.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// Corners count three a facet, counter-clockwise. Where an edge has not two facets that run along it in
/// opposite directions there is nothing opposite.
class CornerTable {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  CornerTable(std::span<const std::array<std::uint32_t, 3>> facets, std::size_t vertices);

  static std::uint32_t next(std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static std::uint32_t previous(std::uint32_t c) { return c % 3 == 0 ? c + 2 : c - 1; }

  std::size_t facets() const { return vertex_.size() / 3; }
  std::size_t vertices() const { return corner_.size(); }
  bool alive(std::size_t facet) const { return vertex_[3 * facet] != none; }
  /// The vertex at a corner.
  std::uint32_t vertex(std::uint32_t c) const { return vertex_[c]; }
  std::array<std::uint32_t, 3> facet(std::size_t f) const {
    return {vertex_[3 * f], vertex_[3 * f + 1], vertex_[3 * f + 2]};
  }
  bool has_facets(std::uint32_t v) const { return corner_[v] != none; }

  /// The corners at a vertex, counter-clockwise; empty where its facets do not close up.
  void star(std::uint32_t v, std::vector<std::uint32_t>& corners) const;

  /// Merges the vertex of corner c, whose facets close up, into that of the next corner; the link condition
  /// must hold.
  void collapse(std::uint32_t c);

 private:
  void join(std::uint32_t a, std::uint32_t b);

  std::vector<std::uint32_t> vertex_, opposite_; ///< by corner
  std::vector<std::uint32_t> corner_;            ///< by vertex: one of its corners
};

} // namespace isoscope
