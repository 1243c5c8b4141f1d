// Which vertices the patches of one batch read and change, so that they can be evaluated side by side.
#pragma once

#include "improve/live_surface.h"

namespace isoscope {

/// Patches of a batch at most.
constexpr std::size_t most_batch = 16;
/// Edges looked at while a batch is filled: bounds what is set aside because of overlaps.
constexpr std::size_t most_looked_at = 64;

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
  /// Takes and claims the patch whose free vertices are at most `rings` edges from a and b; nothing where
  /// that fails.
  std::optional<SurfacePatch> take(const LiveSurface& surface, std::uint32_t a, std::uint32_t b, int rings);
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
