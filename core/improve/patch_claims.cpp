// Claims by the number of the batch.
#include "improve/patch_claims.h"

namespace isoscope {

bool PatchClaims::claim(const SurfacePatch& patch) {
  std::span<const std::uint32_t> looked_at;
  if (patch.in_t) looked_at = patch.in_t->looked_at;
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    const Claim& c = claims_[patch.vertices[i]];
    if (c.write == batch_ || (patch.free[i] && c.read == batch_)) return false;
  }
  for (const std::uint32_t v : looked_at)
    if (claims_[v].write == batch_) return false;
  for (const std::uint32_t v : looked_at) claims_[v].read = batch_;
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    Claim& c = claims_[patch.vertices[i]];
    c.read = batch_;
    if (patch.free[i]) c.write = batch_;
  }
  return true;
}

std::optional<SurfacePatch> PatchClaims::take(const LiveSurface& surface, std::uint32_t a, std::uint32_t b,
                                              int rings) {
  if (is_read(a) || is_read(b)) return std::nullopt;
  SurfacePatch patch = surface.patch(vertices_around(surface.complex(), {a, b}, rings));
  if (!claim(patch)) return std::nullopt;
  return patch;
}

} // namespace isoscope
