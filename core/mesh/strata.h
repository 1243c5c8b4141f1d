// The strata of Z in T: sheets, the curves where they end or meet, and the points where curves do (§4.1,
// §4.2, core/README.md, N8). They follow from sides and dropped facets alone.
#pragma once

#include "mesh/complex.h"
#include "mesh/edge_star.h"
#include "mesh/incidence.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace isoscope {

/// Where a vertex or an edge of T lies among the facets between two sides, those that are dropped included:
/// the border of Z is where facets of Z meet dropped ones. A lower one survives a collapse.
enum class Stratum : std::uint8_t {
  point, ///< a vertex where curves end, branch or meet, or sheets touch
  curve, ///< any other than two facets of one kind: the border of Z, a triple curve
  sheet, ///< two facets, between the same sides and both of Z or both dropped
  room   ///< no such facet
};

/// A facet between two sides as seen from one of its vertices: an arc of that vertex's link.
struct LinkArc {
  std::uint32_t from = 0, to = 0; ///< the other two vertices, by any numbers
  FacetKind kind;
};
/// What a vertex with this link is.
Stratum stratum_of(std::span<const LinkArc> link);
/// The other ends of its edges that lie on curves, ascending.
std::vector<std::uint32_t> curves_from(std::span<const LinkArc> link);
/// The other ends of its edges on the border of Z: with one facet of Z; ascending.
std::vector<std::uint32_t> borders_from(std::span<const LinkArc> link);

/// The link of a vertex of T, by ids.
std::vector<LinkArc> link_arcs(const Complex& complex, const Incidence& incidence, VertexId v);
Stratum stratum_of(const Complex& complex, const Incidence& incidence, VertexId v);
/// Whether a facet of Z has the vertex; Z must be embedded.
bool on_zero_set(const Complex& complex, const Incidence& incidence, VertexId v);

/// The same of an edge and its ends.
struct EdgeStrata {
  Stratum a = Stratum::room, b = Stratum::room, edge = Stratum::room;
  bool border = false; ///< the edge has one facet of Z
  /// Whether a has to stay where it is: it lies on a curve or is a point, and b is of a higher stratum.
  bool pinned() const { return a < b && a <= Stratum::curve; }
};
EdgeStrata strata_of(const EdgeStar& star);
/// The link of an end (0 or 1) of the edge in an embedded star, by local numbers.
std::vector<LinkArc> link_arcs(std::span<const StarFacet> facets, std::uint16_t end);

/// The ends of an edge, first the one that stays: that of the lower stratum, the vertex of Z, else the older
/// one.
std::pair<VertexId, VertexId> oriented_edge(const Complex& complex, const Incidence& incidence, VertexId a,
                                            VertexId b);

} // namespace isoscope
