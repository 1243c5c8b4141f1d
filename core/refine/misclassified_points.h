// Points whose side of the input is known and which f has on the other side: where Z may have a handle too
// many or too few (condition 4).
#pragma once

#include "base/run_control.h"
#include "refine/live_triangulation.h"
#include "tolerance/tolerance_volume.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isoscope {

/// A candidate to mend the topology. Only meaningful where the sides of the input are known, or those of open
/// sheets.
struct MisclassifiedPoint {
  Vec3 point;
  int label = +1;   ///< its true side
  double depth = 0; ///< its distance to the input
  Vec3 summit; ///< straight away from the input until another part of the input is as near: on the same side
  double height = 0; ///< the distance of the summit
  TetId tet;         ///< a tetrahedron that holds the point
};

/// What edges (N = 2) or facets (N = 3) of T tell. Remembers it: from one call to the next only those of
/// tetrahedra that are new since then are looked at.
template <std::size_t N> class MisclassifiedSearch {
 public:
  /// On every edge of T that crosses the input more than once: the deepest point of each stretch between two
  /// crossings that f has on the wrong side. If no simplex with vertices of one label met the input, the
  /// input's genus would bound that of Z. On every facet of T with vertices of one label that edges of the
  /// input pierce: the deepest point found between two piercings that is on the other side. Highest summit
  /// first. Some only once the control is cancelled, as with the functions below.
  std::vector<MisclassifiedPoint> find(const LiveTriangulation& live, const ToleranceVolume& volume,
                                       const RunControl& control);
  /// Ω is another one.
  void forget();

 private:
  struct Found {
    std::array<VertexId, N> simplex;
    MisclassifiedPoint point;
  };
  std::vector<Found> found_;             ///< by their vertices, ascending
  std::vector<std::uint32_t> looked_at_; ///< the generation of each slot of T then
};
extern template class MisclassifiedSearch<2>;
extern template class MisclassifiedSearch<3>;

/// The summits above the middles of the input's triangles and of their edges, on both sides, where walls or
/// gaps are thinner than 2δ': whatever T is, f should have their sides. Highest first; `tet` stays invalid.
std::vector<MisclassifiedPoint> thin_summits(const ToleranceVolume& volume, const RunControl& control);

/// The centres of the octree's leaves with φ from `level` on that f has on another side than that to which
/// the way over the largest φ leads: where Z cuts a region in two, or a pocket off. Highest φ first; only
/// where sides are told by depth.
std::vector<MisclassifiedPoint> misclassified_basins(const LiveTriangulation& live,
                                                     const ToleranceVolume& volume, double level,
                                                     const RunControl& control);

/// Points along the contacts of the input, at most about `spacing` apart: inside where parts are to be
/// joined; between rooms of one that keeps another from joining itself. All of the same height; `tet` stays
/// invalid.
std::vector<MisclassifiedPoint> contact_points(const ToleranceVolume& volume, double spacing,
                                               const RunControl& control);

/// Whether an edge of t passes through a wall or gap thinner than 2δ' that f does not see there, and which no
/// sample tells. Only meaningful for closed input without self-intersections.
bool spans_thin_place(const LiveTriangulation& live, const ToleranceVolume& volume, TetId t);

} // namespace isoscope
