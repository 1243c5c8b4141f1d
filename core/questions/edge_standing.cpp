// The facets between sides at an edge, counted.
#include "questions/edge_standing.h"

#include <algorithm>
#include <functional>

namespace isoscope {

EdgeStanding edge_standing(const EdgeStar& star, const LinkVerdict& link) {
  EdgeStanding s;
  s.strata = strata_of(star);
  for (const EdgeStar::StarTet& t : star.tets)
    if (t.ring() && t.side != 0) s.labels.push_back(t.side);
  std::sort(s.labels.begin(), s.labels.end(), std::greater<>());
  s.labels.erase(std::unique(s.labels.begin(), s.labels.end()), s.labels.end());
  for (const StarFacet& f : side_facets(star))
    if (f.ring()) ++(f.dropped ? s.dropped : s.kept);

  const auto answer = [](bool holds) { return holds ? LinkAnswer::holds : LinkAnswer::fails; };
  s.in_t = answer(link.holds_in_t);
  const bool on_zero_set = star.vertices[0].value == 0 && star.vertices[1].value == 0;
  if (star.form != ZeroForm::embedded || !on_zero_set) return s;
  s.in_sheets = answer(link.holds_in_zero_set);
  if (link.holds_in_zero_set && s.strata.a <= Stratum::curve && s.strata.b <= Stratum::curve)
    s.on_curves = answer(link.holds_on_curves);
  return s;
}

std::size_t facets_at(const ZeroSet& zero_set, VertexId a, VertexId b) {
  return static_cast<std::size_t>(
      std::count_if(zero_set.polygons.begin(), zero_set.polygons.end(), [&](const ZeroSet::Polygon& p) {
        std::size_t ends = 0;
        for (std::size_t k = 0; k < p.count; ++k) {
          const VertexId v = zero_set.vertices[p.v[k]].negative;
          ends += v == a || v == b ? 1u : 0u;
        }
        return ends == 2;
      }));
}

} // namespace isoscope
