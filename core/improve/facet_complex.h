// Points, facets, stars and border of a surface, or of a piece of one: what collapses, flips and relocations
// work on.
#pragma once

#include "base/geometry.h"
#include "base/ids.h"
#include "base/labels.h"
#include "improve/facet_strata.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace isoscope {

/// Weights of a facet's three corners.
using Barycentric = std::array<double, 3>;

/// A sample of one side of ∂Ω that a facet has to leave on that side (condition 3).
struct SideSample {
  Vec3 point;
  double label = 1; ///< +1 or -1
};

/// A facet with what is known about its distance to the input.
struct Facet {
  static constexpr std::uint32_t none = 0xffffffffu;

  std::array<std::uint32_t, 3> v{none, none, none}; ///< counter-clockwise seen from outside
  double energy = 0;              ///< mean of (d/δ)^12 over its samples, plus a penalty when folded
  double largest = 0;             ///< largest sampled d
  bool folded = false;            ///< turned away from the input's normals
  bool proven = false;            ///< inside Ω by certificate
  std::uint8_t misoriented = 0;   ///< failed tests of condition 3, at most 6
  LabelPair labels{+1, -1};       ///< what it lies between; nothing changes that
  TriangleId seed;                ///< an input triangle close to it
  std::vector<Barycentric> extra; ///< where certificates failed: sampled too

  std::vector<SideSample> sides; ///< where tests of condition 3 failed: sampled too

  bool alive() const { return v[0] != none; }
  bool bounds(std::int8_t label) const { return labels.front == label || labels.back == label; }
  /// 0, 1 or 2: which corner the vertex is.
  std::size_t corner(std::uint32_t vertex) const { return v[0] == vertex ? 0 : (v[1] == vertex ? 1 : 2); }
  bool has(std::uint32_t vertex) const { return v[0] == vertex || v[1] == vertex || v[2] == vertex; }
};

/// An edge of the border, with its facet on the left, and what is known about its distance to the rim of the
/// input. It is held at the vertex where it begins.
struct BorderEdge {
  static constexpr std::uint32_t none = 0xffffffffu, elsewhere = 0xfffffffeu;

  std::uint32_t next = none; ///< where it ends; none: no border here; elsewhere: it is not in this piece
  std::vector<Vec3> rim;     ///< samples of the rim that it has to be near
  double energy = 0;         ///< mean of (d/δ)^12 over its own samples and those of the rim
  double largest = 0;        ///< largest sampled d, either way
  bool proven = false;       ///< within δ of the rim, by branch and bound

  bool here() const { return next < elsewhere; }
};

/// One facet of a star in cyclic order: (centre, rim, next wedge's rim).
struct Wedge {
  std::uint32_t rim = 0, next = 0;
  std::uint32_t facet = 0;
  std::uint8_t corner = 0; ///< which corner of the facet is the centre
};

/// Indexed facets with the star of each vertex. Ids are stable: what dies leaves a gap.
struct FacetComplex {
  std::vector<Vec3> points;
  std::vector<Facet> facets;
  std::vector<std::vector<std::uint32_t>> stars; ///< facets of each vertex, in no particular order
  std::vector<BorderEdge> border;                ///< by vertex; empty where the surface is closed
  std::vector<VertexStratum> strata;             ///< by vertex; empty where there are two sides only

  Triangle3 triangle(const Facet& f) const { return {points[f.v[0]], points[f.v[1]], points[f.v[2]]}; }
  Triangle3 triangle(std::size_t f) const { return triangle(facets[f]); }
  bool alive_vertex(std::uint32_t v) const { return !stars[v].empty(); }
  /// Fills `stars` from `facets`.
  void build_stars();
  /// Fills `border` from `facets` and `stars`.
  void build_border();
  bool on_border(std::uint32_t v) const { return !border.empty() && border[v].next != BorderEdge::none; }
  /// Whether a border edge joins them, in either direction.
  bool has_border_edge(std::uint32_t a, std::uint32_t b) const {
    return !border.empty() && (border[a].next == b || border[b].next == a);
  }
  /// Whether the edge lies on a curve where sheets meet.
  bool on_curve(std::uint32_t a, std::uint32_t b) const { return !strata.empty() && strata[a].leads_to(b); }
  bool is_rigid(std::uint32_t v) const { return !strata.empty() && strata[v].rigid; }
  /// The vertex from which a border edge leads to v; v's star must be complete.
  std::uint32_t border_before(std::uint32_t v) const;
  /// A vertex needs more facets than this to lose one.
  std::size_t fewest_facets(std::uint32_t v) const;
  /// Every edge once, its smaller end first, in the order of the facets; ascending where there are strata.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges() const;
  /// Vertices that share a facet with v, ascending.
  std::vector<std::uint32_t> neighbors(std::uint32_t v) const;
  bool has_edge(std::uint32_t a, std::uint32_t b) const;
  /// The facet left of the directed edge, which is on no curve, or Facet::none.
  std::uint32_t facet_left_of(std::uint32_t from, std::uint32_t to) const;
  /// Gives a facet other corners (or none): keeps the stars, drops its extra samples.
  void replace_facet(std::uint32_t f, std::array<std::uint32_t, 3> v);

  /// The star of v in cyclic order, from border to border where v is on it, sheet by sheet where several
  /// meet; v's star must be complete.
  std::vector<Wedge> star(std::uint32_t v) const;
  /// The star that the merged vertex of the edge ab would have; needs the link condition.
  std::vector<Wedge> merged_star(std::uint32_t a, std::uint32_t b) const;
  /// The link conditions of a surface and of its border (core/README.md, N8), and not the last four facets of
  /// a closed component. The stars of a and b must be complete.
  bool link_condition(std::uint32_t a, std::uint32_t b) const;
  /// Merges b into a; positions stay. The link condition must hold.
  void collapse(std::uint32_t a, std::uint32_t b);

 private:
  bool border_link_condition(std::uint32_t a, std::uint32_t b) const;
  void merge_border(std::uint32_t a, std::uint32_t b);
};

} // namespace isoscope
