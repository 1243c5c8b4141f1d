// What was journaled of the sweeps, or the collapse made once more on the star alone.
#include "questions/refused_facet.h"

#include <algorithm>
#include <array>
#include <vector>

namespace isoscope {
namespace {

constexpr int grid = 12;           ///< points along an edge
constexpr std::size_t climbed = 8; ///< of the farthest points of the grid, from each a search goes on
constexpr double finest = 1e-3;    ///< step of that search, as a share of the edges

/// A point by its weights of the second and the third corner, with its distance.
struct Probed {
  double u = 0, v = 0, distance = -1;
};

class FacetProbe {
 public:
  FacetProbe(const Triangle3& t, const ToleranceField& input) : t_(t), input_(input) {}

  RefusedFacet farthest() const {
    std::vector<Probed> points;
    for (int i = 0; i <= grid; ++i)
      for (int j = 0; i + j <= grid; ++j) points.push_back(at(double(i) / grid, double(j) / grid));
    std::stable_sort(points.begin(), points.end(),
                     [](const Probed& a, const Probed& b) { return a.distance > b.distance; });
    Probed best;
    for (std::size_t i = 0; i < std::min(climbed, points.size()); ++i)
      if (const Probed p = climb(points[i]); p.distance > best.distance) best = p;
    const Vec3 place = point(best.u, best.v);
    return {t_, place, input_.closest(place).point, best.distance};
  }

 private:
  Vec3 point(double u, double v) const { return (1 - u - v) * t_[0] + u * t_[1] + v * t_[2]; }
  Probed at(double u, double v) const { return {u, v, input_.distance(point(u, v))}; }
  /// Uphill by ever smaller steps along the edges, within the triangle.
  Probed climb(Probed p) const {
    constexpr std::array<std::array<double, 2>, 6> ways{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}}};
    for (double step = 1.0 / grid; step > finest; step /= 2)
      for (const auto& way : ways) {
        const double u = p.u + step * way[0], v = p.v + step * way[1];
        if (u < 0 || v < 0 || u + v > 1) continue;
        if (const Probed next = at(u, v); next.distance > p.distance) p = next;
      }
    return p;
  }

  const Triangle3& t_;
  const ToleranceField& input_;
};

/// Which reasons say that a facet is too far away.
bool is_too_far(Reason reason) {
  return reason == Reason::stays_above || reason == Reason::outside_tolerance || reason == Reason::unproven;
}

} // namespace

std::optional<RefusedFacet> refused_facet(const Journal& journal, const Event& event,
                                          const StateSnapshot& state, const ToleranceField& input,
                                          std::optional<std::size_t> sweep) {
  const bool refused = event.kind == EventKind::rejection;
  if (event.detail > 0 && event.detail < journal.repairs().size()) {
    const RepairDetail& sweeps = journal.repairs()[event.detail];
    // What was committed is in the mesh; its last sweep left nothing above δ.
    if (sweeps.empty() || (!refused && !sweep)) return std::nullopt;
    return FacetProbe(sweeps[std::min(sweep.value_or(sweeps.size()), sweeps.size() - 1)].worst_facet, input)
        .farthest();
  }
  if (!refused || event.stage != Stage::improve || !is_too_far(event.reason) ||
      state.complex.form != ZeroForm::free)
    return std::nullopt;
  std::optional<RefusedFacet> worst;
  for (const auto& f : state.complex.facets) {
    if (!f.alive()) continue;
    int ends = 0;
    Triangle3 t;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_end = f.v[k] == event.vertex || f.v[k] == event.other;
      ends += is_end;
      t[k] = is_end ? event.point : state.complex.position(f.v[k]);
    }
    if (ends != 1) continue;
    const RefusedFacet facet = FacetProbe(t, input).farthest();
    if (!worst || facet.distance > worst->distance) worst = facet;
  }
  return worst;
}

} // namespace isoscope
