// Strong integer ids: a vertex, a tetrahedron and a sample cannot be mixed up.
#pragma once

#include <compare>
#include <cstdint>

namespace isoscope {

/// A 32-bit index that only compares with its own kind. Default-constructed it is invalid.
template <class Tag> struct Id {
  static constexpr std::uint32_t none = 0xffffffffu;
  std::uint32_t value = none;

  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t v) : value(v) {}
  constexpr explicit Id(std::size_t v) : value(static_cast<std::uint32_t>(v)) {}
  constexpr explicit Id(int v) : value(static_cast<std::uint32_t>(v)) {}
  constexpr bool valid() const { return value != none; }
  constexpr std::size_t index() const { return value; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

using VertexId = Id<struct VertexTag>;     ///< vertex of T; never reused within a run
using TetId = Id<struct TetTag>;           ///< slot of a tetrahedron of T; reused after its tetrahedron died
using SampleId = Id<struct SampleTag>;     ///< index into S
using TriangleId = Id<struct TriangleTag>; ///< index into the input's triangles
using FacetId = Id<struct FacetTag>;       ///< slot of a facet of Z that has left T; reused after it died

/// Number of operations applied so far: the state at step k is what the first k operations made.
using Step = std::uint32_t;

} // namespace isoscope
