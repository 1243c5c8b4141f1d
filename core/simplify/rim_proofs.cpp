// Each facet, edge and place of the rim by branch and bound, in parallel; what is proven once stays so.
#include "simplify/rim_proofs.h"

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "tolerance/facet_certificate.h"

#include <algorithm>
#include <utility>

namespace isoscope {
namespace {

/// Edges are not split below this length, in units of δ.
constexpr double shortest_edge = 0.02;
/// The longest edge of a facet is much longer than another one from this on.
constexpr double much_longer = 1.1;
/// Nor so below this one, where a place of the rim has no border and Z is kept all around it: what is over
/// the rim there would have been met.
constexpr double gap_edge = 0.2;

} // namespace

bool RimProofs::want(std::vector<RimSplit>& splits, const RimSurface& z, RimEdge edge, Reason reason,
                     Vec3 witness, double value) const {
  if (length(edge) < 2 * shortest_edge * volume_.thresholds().delta || z.whole.contains(edge)) return false;
  splits.push_back({edge, reason, witness, value});
  return true;
}

std::vector<VertexId> RimProofs::stuck() const {
  std::vector<VertexId> corners;
  const auto d = [&](VertexId v) { return volume_.field().distance(live_.complex().position(v)); };
  for (const RimFacet& f : stuck_)
    corners.push_back(
        *std::max_element(f.begin(), f.end(), [&](VertexId a, VertexId b) { return d(a) < d(b); }));
  sort_unique(corners);
  return corners;
}

std::vector<VertexId> RimProofs::stuck_border() const {
  const ClosestPointIndex& curve = volume_.open_sides()->rim().curve();
  std::vector<VertexId> ends;
  for (const RimEdge& e : stuck_border_)
    for (const VertexId v : e)
      if (curve.distance(live_.complex().position(v)) > volume_.thresholds().delta) ends.push_back(v);
  sort_unique(ends);
  return ends;
}

/// Facets that are kept and not proven to be inside Ω, each by its longest edge.
void RimProofs::want_inside(const RimSurface& z, std::vector<RimSplit>& splits) {
  const Complex& complex = live_.complex();
  const double delta = volume_.thresholds().delta;
  std::vector<FacetVerdict> inside(z.kept.size());
  parallel_for(z.kept.size(), 16, [&](std::size_t i) {
    if (proven_.contains(z.kept[i])) return;
    const Triangle3 t{complex.position(z.kept[i][0]), complex.position(z.kept[i][1]),
                      complex.position(z.kept[i][2])};
    inside[i] = certify_facet(volume_.field(), t, delta, delta, rim_piece_budget);
  });
  for (std::size_t i = 0; i < z.kept.size(); ++i) {
    if (proven_.contains(z.kept[i])) continue;
    if (inside[i].kind == FacetVerdict::Kind::inside) {
      proven_.insert(z.kept[i]);
      continue;
    }
    const auto all = rim_edges(z.kept[i]);
    const RimEdge longest = *std::max_element(
        all.begin(), all.end(), [&](const RimEdge& x, const RimEdge& y) { return length(x) < length(y); });
    if (!want(splits, z, longest, Reason::leaves_volume, inside[i].witness, inside[i].closest.distance()))
      stuck_.push_back(z.kept[i]);
  }
}

/// The facets at each edge.
class RimProofs::FacetsAt {
 public:
  explicit FacetsAt(std::span<const RimFacet> facets) {
    uses_.reserve(3 * facets.size());
    for (std::uint32_t i = 0; i < facets.size(); ++i)
      for (const RimEdge& e : rim_edges(facets[i])) uses_.emplace_back(e, i);
    std::sort(uses_.begin(), uses_.end());
  }
  /// Calls visit(facet) in ascending order.
  template <class Visit> void visit(const RimEdge& edge, const Visit& visit) const {
    for (auto use = std::lower_bound(uses_.begin(), uses_.end(), std::pair(edge, std::uint32_t{0}));
         use != uses_.end() && use->first == edge; ++use)
      visit(use->second);
  }

 private:
  std::vector<std::pair<RimEdge, std::uint32_t>> uses_;
};

/// From an edge to the longest of the facets at it, as long as that is much longer, and on from there [Rivara
/// 1997]. Halving edges of what is long and thin would come back to edges as long as before.
RimEdge RimProofs::longest_beside(const RimSurface& z, const FacetsAt& facets, RimEdge edge) const {
  for (RimEdge longest = edge;; edge = longest) {
    facets.visit(edge, [&](std::uint32_t f) {
      for (const RimEdge& e : rim_edges(z.facets[f]))
        if (length(e) > std::max(much_longer * length(edge), length(longest)) && !z.whole.contains(e))
          longest = e;
    });
    if (longest == edge) return edge;
  }
}

/// Edges of the border that are not proven to be within δ of the rim.
void RimProofs::want_near_rim(const RimSurface& z, std::vector<RimSplit>& splits) {
  const double delta = volume_.thresholds().delta;
  const ClosestPointIndex& curve = volume_.open_sides()->rim().curve();
  std::vector<FacetVerdict> near(z.border.size());
  parallel_for(z.border.size(), 16, [&](std::size_t i) {
    if (near_rim_.contains(z.border[i])) return;
    const auto [a, b] = segment(z.border[i]);
    near[i] = certify_facet(curve, {a, b, b}, delta, delta, rim_piece_budget);
  });
  const FacetsAt facets(z.facets);
  for (std::size_t i = 0; i < z.border.size(); ++i) {
    if (near_rim_.contains(z.border[i])) continue;
    if (near[i].kind == FacetVerdict::Kind::inside)
      near_rim_.insert(z.border[i]);
    else if (!want(splits, z, longest_beside(z, facets, z.border[i]), Reason::border_off_rim, near[i].witness,
                   near[i].closest.distance()))
      stuck_border_.push_back(z.border[i]);
  }
}

/// Places of the rim that no border is proven to be within δ of: the facet of Z there goes on to them.
void RimProofs::want_rim_reached(const RimSurface& z, std::vector<RimSplit>& splits,
                                 const std::function<bool(VertexId)>& is_kept) {
  if (z.border.empty()) return;
  const double delta = volume_.thresholds().delta;
  std::vector<Segment3> border;
  for (const RimEdge& e : z.border) border.push_back(segment(e));
  const ClosestPointIndex index(flat_triangles(border));
  const auto pieces = volume_.open_sides()->rim().pieces();
  std::vector<FacetVerdict> reached(pieces.size());
  parallel_for(pieces.size(), 16, [&](std::size_t i) {
    reached[i].kind = FacetVerdict::Kind::inside;
    if (pieces[i].open)
      reached[i] =
          certify_facet(index, {pieces[i].a, pieces[i].b, pieces[i].b}, delta, delta, rim_piece_budget);
  });
  std::erase_if(reached, [](const FacetVerdict& v) { return v.kind == FacetVerdict::Kind::inside; });
  if (reached.empty()) return;
  TriangleSoup soup;
  for (const RimFacet& f : z.facets) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const VertexId v : f) soup.points.push_back(live_.complex().position(v));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const ClosestPointIndex zero_set(soup);
  // The longest edge from what is kept to what is not, where the facet has one, else the longest.
  const auto edge_towards = [&](const RimFacet& facet) {
    const auto all = rim_edges(facet);
    const auto rank = [&](const RimEdge& e) { return std::pair{is_kept(e[0]) != is_kept(e[1]), length(e)}; };
    return *std::max_element(all.begin(), all.end(),
                             [&](const RimEdge& x, const RimEdge& y) { return rank(x) < rank(y); });
  };
  for (const FacetVerdict& verdict : reached) {
    const RimFacet& facet = z.facets[zero_set.closest(verdict.witness).triangle.index()];
    const RimEdge edge = edge_towards(facet);
    const auto kept = std::count_if(facet.begin(), facet.end(), is_kept);
    const bool alike = kept == 0 || kept == 3;
    if ((!alike || length(edge) > gap_edge * delta) &&
        want(splits, z, edge, Reason::rim_off_border, verdict.witness, verdict.closest.distance()))
      continue;
    if (!alike) continue;
    const auto d = [&](VertexId v) { return distance(live_.complex().position(v), verdict.witness); };
    gaps_.push_back(
        {verdict.witness,
         *std::min_element(facet.begin(), facet.end(), [&](VertexId a, VertexId b) { return d(a) < d(b); })});
  }
}

std::vector<RimSplit> RimProofs::wanted_splits(const RimSurface& z,
                                               const std::function<bool(VertexId)>& is_kept) {
  std::vector<RimSplit> splits;
  stuck_.clear();
  gaps_.clear();
  stuck_border_.clear();
  want_inside(z, splits);
  want_near_rim(z, splits);
  want_rim_reached(z, splits, is_kept);
  std::stable_sort(splits.begin(), splits.end(),
                   [](const RimSplit& x, const RimSplit& y) { return x.edge < y.edge; });
  splits.erase(std::unique(splits.begin(), splits.end(),
                           [](const RimSplit& x, const RimSplit& y) { return x.edge == y.edge; }),
               splits.end());
  return splits;
}

} // namespace isoscope
