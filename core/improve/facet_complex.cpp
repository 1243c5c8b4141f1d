// Connectivity of small and large facet complexes.
#include "improve/facet_complex.h"

#include "base/sort_unique.h"

#include <algorithm>

namespace isoscope {
namespace {

/// Brings the wedges into cyclic order: each one's `next` is its successor's rim. Where it begins is `first`
/// if that is one of their rims.
void chain(std::vector<Wedge>& wedges, std::uint32_t first) {
  for (Wedge& w : wedges)
    if (w.rim == first) std::swap(w, wedges.front());
  for (std::size_t i = 0; i + 1 < wedges.size(); ++i)
    for (std::size_t j = i + 1; j < wedges.size(); ++j)
      if (wedges[j].rim == wedges[i].next) {
        std::swap(wedges[i + 1], wedges[j]);
        break;
      }
}

/// The same of the sheets around a vertex on a curve, one after the other. Where the next one begins at the
/// end of the last it may go on from there.
void chain_sheets(std::vector<Wedge>& wedges) {
  for (auto at = wedges.begin(); at != wedges.end(); ++at) {
    auto follows = wedges.end();
    if (at != wedges.begin())
      follows = std::find_if(at, wedges.end(), [&](const Wedge& w) { return w.rim == (at - 1)->next; });
    if (follows == wedges.end())
      follows = std::find_if(at, wedges.end(), [&](const Wedge& w) {
        return std::none_of(at, wedges.end(), [&](const Wedge& other) { return other.next == w.rim; });
      });
    if (follows != wedges.end()) std::iter_swap(at, follows);
  }
}

} // namespace

std::size_t FacetComplex::fewest_facets(std::uint32_t v) const {
  if (is_rigid(v)) return stars[v].size();
  return on_border(v) || (!strata.empty() && strata[v].on_curve()) ? 1 : 3;
}

void FacetComplex::build_stars() {
  stars.assign(points.size(), {});
  for (std::uint32_t f = 0; f < facets.size(); ++f)
    if (facets[f].alive())
      for (const std::uint32_t v : facets[f].v) stars[v].push_back(f);
}

void FacetComplex::build_border() {
  border.clear();
  for (const Facet& f : facets) {
    if (!f.alive()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = f.v[k], to = f.v[(k + 1) % 3];
      if (facet_left_of(to, from) != Facet::none) continue;
      border.resize(points.size());
      border[from].next = to;
    }
  }
}

std::uint32_t FacetComplex::border_before(std::uint32_t v) const {
  for (const std::uint32_t f : stars[v]) {
    const std::uint32_t before = facets[f].v[(facets[f].corner(v) + 2) % 3];
    if (border[before].next == v) return before;
  }
  return BorderEdge::none;
}

std::vector<std::uint32_t> FacetComplex::neighbors(std::uint32_t v) const {
  std::vector<std::uint32_t> found;
  found.reserve(2 * stars[v].size());
  for (const std::uint32_t f : stars[v])
    for (const std::uint32_t w : facets[f].v)
      if (w != v) found.push_back(w);
  sort_unique(found);
  return found;
}

bool FacetComplex::has_edge(std::uint32_t a, std::uint32_t b) const {
  return std::any_of(stars[a].begin(), stars[a].end(), [&](std::uint32_t f) { return facets[f].has(b); });
}

std::uint32_t FacetComplex::facet_left_of(std::uint32_t from, std::uint32_t to) const {
  for (const std::uint32_t f : stars[from])
    if (facets[f].v[(facets[f].corner(from) + 1) % 3] == to) return f;
  return Facet::none;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> FacetComplex::edges() const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Facet& f : facets) {
    if (!f.alive()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = f.v[k], to = f.v[(k + 1) % 3];
      if (from < to) edges.emplace_back(from, to);
      if (from > to && (!strata.empty() || (!border.empty() && border[from].next == to)))
        edges.emplace_back(to, from);
    }
  }
  if (!strata.empty()) sort_unique(edges);
  return edges;
}

void FacetComplex::replace_facet(std::uint32_t f, std::array<std::uint32_t, 3> v) {
  Facet& facet = facets[f];
  if (facet.alive())
    for (const std::uint32_t w : facet.v) std::erase(stars[w], f);
  facet.v = v;
  facet.extra.clear();
  facet.sides.clear();
  facet.proven = false;
  if (facet.alive())
    for (const std::uint32_t w : facet.v) stars[w].push_back(f);
}

std::vector<Wedge> FacetComplex::star(std::uint32_t v) const {
  std::vector<Wedge> wedges;
  wedges.reserve(stars[v].size());
  for (const std::uint32_t f : stars[v]) {
    const std::size_t k = facets[f].corner(v);
    wedges.push_back({facets[f].v[(k + 1) % 3], facets[f].v[(k + 2) % 3], f, static_cast<std::uint8_t>(k)});
  }
  if (strata.empty())
    chain(wedges, on_border(v) ? border[v].next : BorderEdge::none);
  else
    chain_sheets(wedges);
  return wedges;
}

std::vector<Wedge> FacetComplex::merged_star(std::uint32_t a, std::uint32_t b) const {
  std::vector<Wedge> wedges;
  wedges.reserve(stars[a].size() + stars[b].size());
  for (const std::uint32_t v : {a, b})
    for (const std::uint32_t f : stars[v]) {
      if (facets[f].has(v == a ? b : a)) continue;
      const std::size_t k = facets[f].corner(v);
      wedges.push_back({facets[f].v[(k + 1) % 3], facets[f].v[(k + 2) % 3], f, static_cast<std::uint8_t>(k)});
    }
  if (!strata.empty()) {
    chain_sheets(wedges);
    return wedges;
  }
  std::uint32_t first = BorderEdge::none;
  for (const std::uint32_t v : {a, b})
    if (on_border(v) && border[v].next != (v == a ? b : a)) first = border[v].next;
  chain(wedges, first);
  return wedges;
}

bool FacetComplex::link_condition(std::uint32_t a, std::uint32_t b) const {
  if (!strata.empty()) return strata_link_condition(*this, a, b);
  const std::vector<std::uint32_t> of_a = neighbors(a), of_b = neighbors(b);
  std::vector<std::uint32_t> common;
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(common));
  if (on_border(a) && on_border(b)) return common.size() == 1 && border_link_condition(a, b);
  if (on_border(a) || on_border(b)) return common.size() == 2;
  return common.size() == 2 && !(of_a.size() == 3 && of_b.size() == 3);
}

/// ab is an edge of the border, and the loop has more than three.
bool FacetComplex::border_link_condition(std::uint32_t a, std::uint32_t b) const {
  if (!has_border_edge(a, b)) return false;
  const auto [from, to] = border[a].next == b ? std::pair(a, b) : std::pair(b, a);
  return border[to].next != border_before(from);
}

void FacetComplex::merge_border(std::uint32_t a, std::uint32_t b) {
  if (!on_border(b)) return;
  const std::uint32_t before = border_before(b);
  BorderEdge gone = std::move(border[b]);
  border[b] = {};
  if (before == a) {
    border[a].rim.insert(border[a].rim.end(), gone.rim.begin(), gone.rim.end());
    border[a].next = gone.next;
    return;
  }
  if (gone.next == a) {
    border[a].rim.insert(border[a].rim.end(), gone.rim.begin(), gone.rim.end());
  } else { // a takes b's place
    border[a] = std::move(gone);
  }
  border[before].next = a;
}

void FacetComplex::collapse(std::uint32_t a, std::uint32_t b) {
  merge_border(a, b);
  const std::vector<std::uint32_t> of_b = stars[b];
  for (const std::uint32_t f : of_b) {
    std::array<std::uint32_t, 3> v = facets[f].v;
    if (facets[f].has(a)) {
      replace_facet(f, {Facet::none, Facet::none, Facet::none});
      continue;
    }
    v[facets[f].corner(b)] = a;
    replace_facet(f, v);
  }
  if (!strata.empty()) merge_strata(*this, a, b);
}

} // namespace isoscope
