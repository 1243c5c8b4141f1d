// Strata from the links of vertices: graphs whose nodes are edges of T and whose arcs are facets.
#include "mesh/strata.h"

#include "base/sort_unique.h"

#include <algorithm>

namespace isoscope {

namespace {

/// A node of a link with one of its arcs.
struct Use {
  std::uint32_t node, arc;
};

/// The arcs of each node, ascending by node.
std::vector<Use> uses_of(std::span<const LinkArc> link) {
  std::vector<Use> uses;
  uses.reserve(2 * link.size());
  for (std::uint32_t i = 0; i < link.size(); ++i) {
    uses.push_back({link[i].from, i});
    uses.push_back({link[i].to, i});
  }
  std::sort(uses.begin(), uses.end(),
            [](const Use& x, const Use& y) { return std::pair(x.node, x.arc) < std::pair(y.node, y.arc); });
  return uses;
}

/// Calls visit(uses of a node) for each node.
template <class Visit> void each_node(const std::vector<Use>& uses, const Visit& visit) {
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i + 1;
    while (end < uses.size() && uses[end].node == uses[i].node) ++end;
    visit(std::span(uses).subspan(i, end - i));
    i = end;
  }
}

bool on_curve(std::span<const LinkArc> link, std::span<const Use> at_node) {
  return at_node.size() != 2 || !(link[at_node[0].arc].kind == link[at_node[1].arc].kind);
}

std::span<const Use> uses_at(const std::vector<Use>& uses, std::uint32_t node) {
  const auto by_node = [](const Use& x, const Use& y) { return x.node < y.node; };
  const auto [first, last] = std::equal_range(uses.begin(), uses.end(), Use{node, 0}, by_node);
  return {first, last};
}

/// Follows arcs through nodes that are no ends; the number of arcs, 0 where that does not lead to `end`.
std::size_t path_length(std::span<const LinkArc> link, const std::vector<Use>& uses, std::uint32_t from,
                        std::uint32_t arc, std::uint32_t end) {
  std::uint32_t node = from;
  for (std::size_t length = 1; length <= link.size(); ++length) {
    node = link[arc].from == node ? link[arc].to : link[arc].from;
    if (node == end) return length;
    const auto at_node = uses_at(uses, node);
    if (node == from || at_node.size() != 2) return 0;
    arc = at_node[0].arc == arc ? at_node[1].arc : at_node[0].arc;
  }
  return 0;
}

/// Whether a tetrahedron has one of the sides ±1 and no dropped facet: where all have, Z is a closed surface.
template <class Tetrahedron> bool is_plain(const Tetrahedron& t) {
  return t.dropped == 0 && t.side >= -1 && t.side <= 1;
}

bool is_plain_at(const Complex& complex, const Incidence& incidence, VertexId v) {
  const auto at = incidence.tets_of(v);
  return std::all_of(at.begin(), at.end(), [&](TetId t) { return is_plain(complex.tet(t)); });
}

} // namespace

Stratum stratum_of(std::span<const LinkArc> link) {
  if (link.empty()) return Stratum::room;
  const std::vector<Use> uses = uses_of(link);
  const std::vector<std::uint32_t> curves = curves_from(link);
  // A sheet closes up around the vertex; a curve joins two nodes by each of its sheets, and nothing else.
  if (curves.empty())
    return path_length(link, uses, link[0].from, 0, link[0].from) == link.size() ? Stratum::sheet
                                                                                 : Stratum::point;
  if (curves.size() != 2) return Stratum::point;
  std::size_t covered = 0;
  for (const Use& u : uses_at(uses, curves[0])) {
    const std::size_t length = path_length(link, uses, curves[0], u.arc, curves[1]);
    if (length == 0) return Stratum::point;
    covered += length;
  }
  return covered == link.size() ? Stratum::curve : Stratum::point;
}

std::vector<std::uint32_t> curves_from(std::span<const LinkArc> link) {
  std::vector<std::uint32_t> ends;
  each_node(uses_of(link), [&](std::span<const Use> at_node) {
    if (on_curve(link, at_node)) ends.push_back(at_node[0].node);
  });
  return ends;
}

std::vector<std::uint32_t> borders_from(std::span<const LinkArc> link) {
  std::vector<std::uint32_t> ends;
  each_node(uses_of(link), [&](std::span<const Use> at_node) {
    const auto kept = std::count_if(at_node.begin(), at_node.end(),
                                    [&](const Use& u) { return !link[u.arc].kind.dropped; });
    if (kept == 1) ends.push_back(at_node[0].node);
  });
  return ends;
}

std::vector<LinkArc> link_arcs(const Complex& complex, const Incidence& incidence, VertexId v) {
  std::vector<LinkArc> arcs;
  for (const TetId t : incidence.tets_of(v)) {
    const Tet& tet = complex.tet(t);
    for (std::size_t k = 0; k < 4; ++k) {
      const TetId n = tet.neighbor[k];
      if (tet.v[k] == v || !n.valid() || complex.tet(n).side >= tet.side) continue;
      LinkArc arc{0, 0, {complex.tet(n).side, tet.side, (tet.dropped >> k & 1u) != 0}};
      bool first = true;
      for (const VertexId w : tet.facet(k)) {
        if (w == v) continue;
        (first ? arc.from : arc.to) = w.value;
        first = false;
      }
      arcs.push_back(arc);
    }
  }
  return arcs;
}

Stratum stratum_of(const Complex& complex, const Incidence& incidence, VertexId v) {
  if (complex.value(v) != 0 || complex.form != ZeroForm::embedded) return Stratum::room;
  if (is_plain_at(complex, incidence, v)) return Stratum::sheet;
  return stratum_of(link_arcs(complex, incidence, v));
}

bool on_zero_set(const Complex& complex, const Incidence& incidence, VertexId v) {
  if (complex.value(v) != 0) return false;
  if (is_plain_at(complex, incidence, v)) return true;
  const std::vector<LinkArc> link = link_arcs(complex, incidence, v);
  return std::any_of(link.begin(), link.end(), [](const LinkArc& arc) { return !arc.kind.dropped; });
}

std::vector<LinkArc> link_arcs(std::span<const StarFacet> facets, std::uint16_t end) {
  std::vector<LinkArc> arcs;
  for (const StarFacet& f : facets) {
    if (!(end == 0 ? f.at_a : f.at_b)) continue;
    LinkArc arc{0, 0, f.kind()};
    bool first = true;
    for (const std::uint16_t v : f.v) {
      if (v == end) continue;
      (first ? arc.from : arc.to) = v;
      first = false;
    }
    arcs.push_back(arc);
  }
  return arcs;
}

EdgeStrata strata_of(const EdgeStar& star) {
  EdgeStrata strata;
  if (star.form != ZeroForm::embedded) return strata;
  if (std::all_of(star.tets.begin(), star.tets.end(), is_plain<EdgeStar::StarTet>)) {
    strata.a = star.vertices[0].value == 0 ? Stratum::sheet : Stratum::room;
    strata.b = star.vertices[1].value == 0 ? Stratum::sheet : Stratum::room;
    if (star.kind() == EdgeKind::zero) strata.edge = Stratum::sheet;
    return strata;
  }
  const std::vector<StarFacet> facets = side_facets(star);
  std::vector<FacetKind> kinds;
  for (const StarFacet& f : facets)
    if (f.ring()) kinds.push_back(f.kind());
  if (!kinds.empty())
    strata.edge = kinds.size() == 2 && kinds[0] == kinds[1] ? Stratum::sheet : Stratum::curve;
  strata.border =
      std::count_if(kinds.begin(), kinds.end(), [](const FacetKind& k) { return !k.dropped; }) == 1;
  strata.a = stratum_of(link_arcs(facets, 0));
  strata.b = stratum_of(link_arcs(facets, 1));
  return strata;
}

std::pair<VertexId, VertexId> oriented_edge(const Complex& complex, const Incidence& incidence, VertexId a,
                                            VertexId b) {
  const bool a_zero = complex.value(a) == 0, b_zero = complex.value(b) == 0;
  if (a_zero != b_zero) return a_zero ? std::pair(a, b) : std::pair(b, a);
  if (a_zero) {
    const Stratum at_a = stratum_of(complex, incidence, a), at_b = stratum_of(complex, incidence, b);
    if (at_a != at_b) return at_a < at_b ? std::pair(a, b) : std::pair(b, a);
  }
  return a < b ? std::pair(a, b) : std::pair(b, a);
}

} // namespace isoscope
