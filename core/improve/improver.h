// The improver: reduces the vertices of Z by minimax placement, relocation, flips and collapse with repair,
// guarded by certificates, exact intersection tests, link conditions and witnesses (core/README.md, N6).
#pragma once

#include "improve/surface_collapses.h"
#include "journal/journal.h"
#include "tolerance/nearest_cells.h"
#include "tolerance/tolerance_volume.h"

#include <functional>
#include <limits>

namespace isoscope {

/// The effort with which the improver ends only when it is stopped.
inline constexpr int endless_effort = 3;

struct ImproverOptions {
  /// 0: greedy collapses to minimax targets; 1: with relaxation between rounds; 2: then collapses with repair
  /// of the 2-ring, at most 5,000 tries, and passes of flips against the energy with collapses after each,
  /// within a bound; 3: then further rounds (further_rounds.h), which end only when they are stopped.
  int effort = 2;
  bool rounds_alone = false;   ///< with effort 3: what comes before the further rounds is left out
  std::size_t first_round = 0; ///< the number of the first of these, from which all their choices follow
  std::size_t most_rounds = std::numeric_limits<std::size_t>::max(); ///< so many of these at most
  bool preserve_normals = true; ///< condition 3 is preserved (§2.4); needs samples
  double shrink = 0.7;          ///< of the facet's copy for condition 3, in (0, 1]
  bool thin = false; ///< first coarsens what is much finer than δ, see thin(); for a Z without border and
                     ///< labels, not inside T, of which no normals are preserved
};

/// What a run's criteria ask of the improver.
ImproverOptions improver_options(const CriteriaParameters& criteria, int effort);

struct ImproverOutcome {
  enum class End { finished, stopped };
  End end = End::finished;
  std::size_t attempts = 0, collapses = 0, repairs = 0; ///< repairs: collapses with repair
  std::size_t shakes = 0, shaken_edges = 0;             ///< passes of flips against the energy; flips
  std::size_t moved = 0, flipped = 0;                   ///< in relaxation sweeps
  std::size_t rounds = 0;                               ///< further ones that were begun
};

/// What the improver asks of Ω.
struct ImproverGround {
  const ToleranceField& field;
  double delta = 0;
  std::vector<Vec3> witnesses;      ///< of every region deeper than δ that lies in the box
  const BorderGate* gate = nullptr; ///< the open rim of the input; null where Z is closed
  /// Where Z may change. With it the mesh may be a piece of Z: all facets whose boxes meet this one; the
  /// field has all of the input within 3 δ of it, turned like Z.
  std::optional<ChangeBox> box = std::nullopt;
  std::size_t most_cell_bytes = NearestCells::most_bytes; ///< for what makes queries faster
};
ImproverGround ground_of(const ToleranceVolume& volume);

/// T around Z, for an improver that stays inside it.
struct RoomInT {
  Embedding& embedding;
  std::function<bool()> make; ///< collapses edges of T that leave Z where it is; false stops the improver
};

/// Improves `mesh`: an oriented 2-manifold without intersections, inside Ω, that separates the regions; an
/// empty one stays so. Its border keeps to the open rim that the volume knows. With labels it is one between
/// rooms: then the curves along which its sheets meet stay what they are (§4.2).
/// Every change keeps that, so the result holds at whatever moment it is cancelled. `samples` may be null:
/// then normals are not preserved. With `room`, whose
/// embedding has `mesh` as its Z, every change is one of T too, whose tetrahedra stay positively oriented.
/// The result depends on the arguments only, not on the number of threads.
ImproverOutcome improve(TriangleMesh& mesh, const ImproverGround& ground, const NearestSample* samples,
                        const ImproverOptions& options, const RunControl& control, ImproverObserver& observer,
                        const RoomInT* room = nullptr);
ImproverOutcome improve(TriangleMesh& mesh, const ToleranceVolume& volume, const NearestSample* samples,
                        const ImproverOptions& options, const RunControl& control, ImproverObserver& observer,
                        const RoomInT* room = nullptr);

} // namespace isoscope
