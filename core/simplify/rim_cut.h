// The cut of an embedded Z along the wall over the rim of open surfaces (§4.1).
#pragma once

#include "base/segment.h"
#include "base/status.h"
#include "collapse/live_complex.h"
#include "journal/stage_log.h"
#include "simplify/rim_patches.h"
#include "simplify/rim_proofs.h"
#include "tolerance/tolerance_volume.h"

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace isoscope {

/// Splits edges of Z in T where the nearest place of the input changes from off the open rim to on it, and
/// drops what lies beyond. What is kept is the part of Z between vertices that are kept: a surface with
/// border. Edges with both ends beyond are looked along for strips between two rims. Where the wall dips into
/// the sheet or comes back, holes and crumbs appear beside those that the loops of the rim make: what no part
/// of the rim needs is closed or dropped, the others are joined to what their loop has made. Edges are split
/// further until every facet kept is proven inside Ω, every edge of the border within δ of the rim and every
/// place of the rim within δ of the border, as far as edges are not too short for that. Then the border is
/// led along the rim to places that Z passes by, and back from where Z leaves Ω before it is over the rim.
class RimCut {
 public:
  RimCut(LiveComplex& live, const ToleranceVolume& volume, StageLog& log);
  /// Every split and the cut are operations. Ends early when the log says stop; goes on where it was when
  /// called again. An error with the place where so much of Z leaves Ω before it is over the rim that no cut
  /// can help.
  Status run();

 private:
  enum class Place : std::uint8_t { unknown, kept, wall, beyond };
  using Edge = RimEdge;
  using Facet = RimFacet;
  struct WornBall {
    Vec3 center;
    double radius;
  };
  /// Edges are looked along at steps of this, in units of δ.
  static constexpr double look_step = 0.25;
  /// A vertex this near to where an edge crosses the wall is on it, in units of δ.
  static constexpr double at_wall = 0.01;
  /// The longest way along which patches of one loop are joined, in units of δ.
  static constexpr double longest_way = 3;
  /// What is so near to the rim, in units of δ, may have the border beside it.
  static constexpr double by_rim = 0.9;
  /// So much more than Z is away from the rim is kept where it has to be, in units of δ.
  static constexpr double tongue = 0.15;

  LiveComplex& live_;
  const ToleranceVolume& volume_;
  StageLog& log_;
  RimProofs proofs_;
  std::vector<Place> places_;    ///< by vertex; of those of Z
  std::vector<Facet> facets_;    ///< of the whole Z, sorted corners, ascending
  std::set<Edge> whole_;         ///< edges that cannot be split
  bool unfolds_ = false;         ///< what is flat beside them is turned
  std::set<Edge> at_end_;        ///< edges that cross the wall at their kept end
  std::set<Edge> looked_at_;     ///< edges that were looked at for strips
  std::set<VertexId> widened_;   ///< vertices in which parts met that were joined there
  std::vector<Vec3> tried_gaps_; ///< places of the rim
  std::vector<WornBall> worn_;   ///< nothing is kept in them
  /// By open piece of the rim: what is nearer to it than that is kept, as far as it is in Ω. Empty: nothing.
  std::vector<double> kept_by_rim_;

  bool is_kept(VertexId v) const {
    return places_[v.index()] == Place::kept || places_[v.index()] == Place::wall;
  }
  bool keeps_facet(const Facet& f) const { return is_kept(f[0]) && is_kept(f[1]) && is_kept(f[2]); }
  // In rim_cut.cpp: splits along the wall.
  bool keeps(Vec3 p) const;
  void classify();
  void collect_facets();
  std::vector<Facet> kept_facets() const;
  std::vector<Edge> border(const std::vector<Facet>& kept) const;
  std::vector<Edge> crossing_edges() const;
  Vec3 wall_between(Vec3 kept, Vec3 beyond) const;
  std::vector<Vec3> places_on_edge(const Edge& edge, Vec3 at) const;
  /// False where a tetrahedron would turn over at any place that was tried.
  bool split(const RimSplit& split, Vec3 at, Place place);
  bool split_at(const RimSplit& split, Vec3 at, Place place);
  bool unfold(const RimSplit& split);
  double height(const Facet& f) const;
  void tell(const RimSplit& split, Vec3 at, Delta delta);
  void cut_edges(const std::vector<Edge>& edges);
  std::optional<Vec3> strip_between(Vec3 a, Vec3 b) const;
  bool find_strips();
  void drop();
  bool is_hopeless(std::size_t kept) const;
  // In rim_mending.cpp and rim_gaps.cpp: patches that are none of a loop, gaps, flaps, pinches.
  std::vector<RimPatch> patches() const;
  bool rim_needs(const RimPatch& patch, const std::vector<RimPatch>& all) const;
  bool lies_within(const RimPatch& patch, const ToleranceField& field) const;
  bool is_crumb(const RimPatch& patch) const;
  std::vector<double> lengths_by_loop(const RimPatch& patch) const;
  void settle_spare_patches();
  void turn(const RimPatch& patch);
  bool join_patches();
  bool join(const RimPatch& patch, const std::vector<const RimPatch*>& to);
  bool is_in_volume(VertexId v) const;
  bool is_near_rim(VertexId v) const;
  double length_by_rim(const Edge& e) const;
  std::array<std::vector<VertexId>, 2> border_by_loop(std::uint32_t loop) const;
  bool close_gaps();
  bool close_gap(const RimGap& gap);
  bool follow_rim(const RimGap& gap);
  bool follow_rim_on(const RimPatch& patch);
  bool keep_by_rim(std::span<const Vec3> places, double radius);
  bool follows_rim(const RimPatch& patch) const;
  bool is_by_kept_rim(Vec3 p) const;
  bool refine_between(const RimPatch& patch, std::span<const RimPatch* const> others);
  std::vector<VertexId> channel_to(const RimGap& gap) const;
  bool refine_around(const RimGap& gap);
  bool refine_around(Vec3 p, double reach);
  std::vector<VertexId> pinches() const;
  bool parts_loops(VertexId v) const;
  bool cut_pinches();
  void set_apart(std::span<const VertexId> vertices, Place place, Reason reason);
  bool wear_away(std::span<const VertexId> vertices);
  bool take_flap(VertexId start);

  Segment3 segment(const Edge& e) const {
    return {live_.complex().position(e[0]), live_.complex().position(e[1])};
  }
  double length(const Edge& e) const { return distance(segment(e)[0], segment(e)[1]); }
};

} // namespace isoscope
