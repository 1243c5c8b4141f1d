// What is proven of Z and the input in one tile, so that the tiles' proofs add up to a certificate of all of
// it.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "run/certificate_verdicts.h"
#include "run/normal_deviation.h"
#include "tiles/tile_folder.h"
#include "tiles/tile_surface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

/// What is proven, and in which tiles: each brick, and so each point of space, is in one.
struct ProofPlan {
  std::uint32_t round = 1; ///< Z before it
  Tiling tiling;
  std::vector<GridPlace> tiles; ///< that anything of Z or the input may lie in
  double piece = 0;             ///< facets and triangles with longer edges are cut for the proofs
  double facet_area = 0;        ///< of Z
  std::uint64_t facets = 0;     ///< of Z
  CoverTest cover;
};
/// The plan for Z as it is once all rounds are complete, in the largest tiles that fit the folder's memory.
/// Reads Z once. Fails with io, bad_input.
Result<ProofPlan> plan_proof(const TileFolder& folder, const CoverTest& cover);

/// Each piece and each place counts in one tile.
struct TileProof {
  TileSurface surface;
  ContainmentFigures containment;            ///< of pieces; counts are of facets, below
  std::vector<Triangle3> outside, undecided; ///< facets with such pieces, ascending
  DistanceBounds input_distance{0, 0, {}};   ///< of the pieces of the input
  Coverage coverage{Coverage::Verdict::covered, {}, 0};
  std::vector<Vec3> witnesses; ///< of {d > δ}
  std::vector<NormalMeasurement> normals;
};
/// Fails with cancelled, with io, bad_input, and as witnesses_of_piece().
Result<TileProof> prove_tile(const TileFolder& folder, const ProofPlan& plan, const GridPlace& tile,
                             const RunControl& control);

} // namespace isoscope
