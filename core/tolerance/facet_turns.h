// How often, and which way round, each triangle of a closed soup counts, so that rays tell its sides.
#pragma once

#include "tolerance/welded_mesh.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace isoscope {

/// What the triangles of a soup bound together.
enum class Closedness : std::uint8_t {
  open,   ///< some edge has an odd number of triangles
  parity, ///< every edge has an even number, but they cannot be oriented so that they cancel along each edge
  oriented, ///< they cancel along each edge: how often the soup winds around a point is a whole number
};

/// The triangles as they count. A triangle that occurs several times counts once, unless all of them are
/// needed to close the soup, as the common face of two boxes is.
struct FacetTurns {
  Closedness closedness = Closedness::open;
  /// By triangle: +1 as it runs, -1 the other way round, 0 not at all; absent: all as they run. Of open soups
  /// present where most triangles have neighbours and can be oriented like them.
  std::shared_ptr<const std::vector<std::int8_t>> turns;
  bool as_given = false; ///< the triangles cancel as they run
  /// Of the surface where it has one side only, or else where its parts cannot be told apart; when `parity`.
  std::optional<Vec3> unoriented;
};

/// Closed parts keep the way round that most of their area has; where there is no such, they run outwards,
/// or inwards inside an odd number of other parts.
FacetTurns find_facet_turns(const WeldedMesh& mesh, const std::vector<EdgeUse>& uses);

/// Triangles that say again what another one says, ascending: without them what is left is closed all the
/// same, and bounds the same. Of several that run both ways one that runs like its neighbours is left. Empty
/// where the soup is open without them or where copies that run both ways close it, as the common face of two
/// boxes does.
std::vector<std::uint32_t> needless_copies(const WeldedMesh& mesh, const std::vector<EdgeUse>& uses);

/// How the triangles of a surface that need not be closed run: each patch of neighbours one way.
struct PatchTurns {
  std::vector<std::int8_t> turns; ///< by triangle, as in FacetTurns
  std::optional<Vec3> one_sided;  ///< where a patch cannot be oriented; `turns` are of no use then
};
PatchTurns orient_patches(const WeldedMesh& mesh, const std::vector<EdgeUse>& uses);

} // namespace isoscope
