// Which vertices the patches of one batch read and change, so that they can be evaluated side by side.
#pragma once

#include "simplify/surface_patch.h"

namespace isoscope {

/// Vertices held by the patches of the present batch.
class PatchClaims {
 public:
  /// For a surface with this many vertex ids.
  explicit PatchClaims(std::size_t vertices) : claims_(vertices) {}
  /// Gives all vertices free.
  void begin_batch() { ++batch_; }
  /// Holds the patch's vertices; false, with nothing held, where another patch changes what this one reads or
  /// reads what this one may change.
  bool claim(const SurfacePatch& patch);
  /// Whether a patch of the batch has the vertex.
  bool is_read(std::uint32_t vertex) const { return claims_[vertex].read == batch_; }

 private:
  struct Claim {
    std::uint32_t write = 0, read = 0; ///< number of the batch that holds the vertex
  };
  std::vector<Claim> claims_;
  std::uint32_t batch_ = 0;
};

} // namespace isoscope
