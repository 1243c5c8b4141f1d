// How many components Z has while T changes in small parts (condition 4).
#pragma once

#include "mesh/complex.h"
#include "mesh/delaunay.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace isoscope {

/// Counts all of Z once, then as long as each change leaves what it joins: Z hangs together from one
/// tetrahedron to the next, so that outside of a change it is as before. One thread.
class ZeroComponents {
 public:
  /// Of Z in all of T, none of whose vertices has f = 0.
  std::size_t count(const Complex& complex, const Delaunay& delaunay);
  /// T, as it is now, has `added` in the place of `removed`, whose vertices have kept their labels.
  void replace(const Complex& complex, std::span<const TetRecord> removed, std::span<const TetRecord> added);
  /// Z may be another one everywhere.
  void forget() { known_.reset(); }

 private:
  /// Where an edge of T crosses Z, as its ends, and the number of the piece that it belongs to.
  using Crossing = std::pair<std::uint64_t, std::uint32_t>;
  /// Pieces of Z in some tetrahedra.
  struct Pieces {
    std::size_t count = 0;
    std::vector<Crossing> crossings; ///< ascending
  };
  static Pieces pieces(const Complex& complex, std::span<const TetRecord> tets);

  std::optional<std::size_t> known_;
};

} // namespace isoscope
