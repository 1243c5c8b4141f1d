// What the cut over the rim has to prove of what it keeps, and where it has to split for that.
#pragma once

#include "base/segment.h"
#include "collapse/live_complex.h"
#include "journal/event.h"
#include "simplify/rim_patches.h"
#include "tolerance/tolerance_volume.h"

#include <functional>
#include <set>
#include <span>
#include <vector>

namespace isoscope {

/// Pieces up to which a proof by branch and bound is carried.
constexpr std::size_t rim_piece_budget = 20000;

/// An edge of Z that is to be split: why, and where the proof failed.
struct RimSplit {
  RimEdge edge;
  Reason reason;
  Vec3 witness;
  double value; ///< the distance there
};

/// A place of the rim without border near to it, and the vertex of Z that is nearest.
struct RimGap {
  Vec3 place;
  VertexId vertex;
};

/// Z during the cut.
struct RimSurface {
  std::span<const RimFacet> facets; ///< all of Z
  std::span<const RimFacet> kept;
  std::span<const RimEdge> border; ///< of what is kept
  const std::set<RimEdge>& whole;  ///< edges that are not to be split
};

class RimProofs {
 public:
  /// Both must outlive it.
  RimProofs(const LiveComplex& live, const ToleranceVolume& volume) : live_(live), volume_(volume) {}
  /// What is not proven yet, each by one edge whose splitting brings it nearer to it; ascending, each edge
  /// once. Proven are: facets that are kept inside Ω, edges of the border within δ of the rim, the open rim
  /// within δ of the border.
  std::vector<RimSplit> wanted_splits(const RimSurface& z, const std::function<bool(VertexId)>& is_kept);
  /// Of the kept facets that the last call found neither proven nor fit to be split: their corner that is
  /// farthest from the input; ascending.
  std::vector<VertexId> stuck() const;
  /// Of the border edges that it found not to be within δ of the rim and not fit to be split: their ends that
  /// are farther than δ from it; ascending.
  std::vector<VertexId> stuck_border() const;
  /// Whether there are such edges, with ends like that or not.
  bool is_border_stuck() const { return !stuck_border_.empty(); }
  /// Of the places of the rim that the last call found farther than δ from the border, those where Z is kept
  /// all around the nearest place of it, or nowhere, and too fine to be split there; in the order of the rim.
  std::span<const RimGap> gaps() const { return gaps_; }

 private:
  void want_inside(const RimSurface& z, std::vector<RimSplit>& splits);
  void want_near_rim(const RimSurface& z, std::vector<RimSplit>& splits);
  void want_rim_reached(const RimSurface& z, std::vector<RimSplit>& splits,
                        const std::function<bool(VertexId)>& is_kept);
  class FacetsAt;
  RimEdge longest_beside(const RimSurface& z, const FacetsAt& facets, RimEdge edge) const;
  /// False where the edge is too short.
  bool want(std::vector<RimSplit>& splits, const RimSurface& z, RimEdge edge, Reason reason, Vec3 witness,
            double value) const;
  Segment3 segment(const RimEdge& e) const {
    return {live_.complex().position(e[0]), live_.complex().position(e[1])};
  }
  double length(const RimEdge& e) const { return distance(segment(e)[0], segment(e)[1]); }

  const LiveComplex& live_;
  const ToleranceVolume& volume_;
  std::vector<RimFacet> stuck_;
  std::vector<RimGap> gaps_;
  std::vector<RimEdge> stuck_border_;
  std::set<RimFacet> proven_;  ///< kept ones that are inside Ω
  std::set<RimEdge> near_rim_; ///< border edges within δ of the rim
};

} // namespace isoscope
