// The rim by its pieces, and the border of Z by the loops that are nearest to it.
#include "questions/rim_questions.h"

#include "base/disjoint_sets.h"
#include "base/point_order.h"
#include "mesh/zero_curves.h"
#include "tolerance/open_sides.h"

#include <algorithm>
#include <limits>
#include <map>

namespace isoscope {
namespace {

/// How near to a corner a place is at it, in units of δ.
constexpr double at_corner = 1e-6;

/// The points of the input at the ends of a triangle's edge that a piece of the rim is part of.
Segment3 edge_of(const Triangle3& t, const RimPiece& piece) {
  Segment3 best{};
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Segment3 edge{t[k], t[(k + 1) % 3]};
    const double off = std::max(distance_to(edge, piece.a), distance_to(edge, piece.b));
    if (off < nearest) nearest = off, best = edge;
  }
  return best;
}

std::uint32_t number_of(const std::vector<Vec3>& points, Vec3 p) {
  return static_cast<std::uint32_t>(std::find(points.begin(), points.end(), p) - points.begin());
}

std::vector<BridgedStretch> bridged_stretches(const Rim& rim) {
  std::vector<const RimPiece*> pieces;
  for (const RimPiece& p : rim.pieces())
    if (!p.open) pieces.push_back(&p);
  DisjointSets sets(pieces.size());
  // Ends of pieces: those that share one are found.
  std::map<Vec3, std::uint32_t, decltype(&lies_before)> first(&lies_before);
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    for (const Vec3 end : {pieces[i]->a, pieces[i]->b}) {
      const auto [at, fresh] = first.emplace(end, i);
      if (!fresh) sets.unite(at->second, i);
    }
  std::map<std::uint32_t, BridgedStretch> stretches;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const RimPiece& p = *pieces[i];
    BridgedStretch& stretch = stretches[sets.find(i)];
    const double length = distance(p.a, p.b);
    stretch.length += length;
    stretch.center += length * (0.5 * (p.a + p.b));
    stretch.meets_wall = stretch.meets_wall || p.meets_wall;
    stretch.pieces.push_back({p.a, p.b});
  }
  std::vector<BridgedStretch> list;
  for (auto& [number, stretch] : stretches) {
    stretch.center = stretch.length > 0 ? stretch.center / stretch.length : stretch.pieces.front()[0];
    list.push_back(std::move(stretch));
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const BridgedStretch& a, const BridgedStretch& b) { return a.length > b.length; });
  return list;
}

} // namespace

const Rim* open_rim(const Scene& scene) {
  const OpenSides* sides = scene.volume ? scene.volume->open_sides() : nullptr;
  return sides != nullptr && !sides->rim().empty() ? &sides->rim() : nullptr;
}

std::optional<RimInspection> inspect_rim(const Scene& scene, Vec3 p) {
  const Rim* rim = open_rim(scene);
  if (rim == nullptr || !scene.input) return std::nullopt;
  const ClosestPoint closest = scene.volume->field().closest(p), on_rim = rim->curve().closest(p);
  RimInspection x;
  x.closest = closest.point;
  x.distance = closest.distance();
  const OpenSides& sides = *scene.volume->open_sides();
  x.over_rim = sides.is_open(closest.triangle) && sides.is_over_rim(p, closest);
  x.on_rim = on_rim.point;
  x.to_rim = on_rim.distance();
  x.loop = rim->loop_near(p);
  if (sides.by_samples()) return x;
  // The curve has the open pieces in their order.
  std::size_t left = on_rim.triangle.index();
  for (const RimPiece& piece : rim->pieces()) {
    if (!piece.open || left-- > 0) continue;
    const Segment3 edge = edge_of(scene.volume->index().triangle(piece.triangle), piece);
    std::array ends{number_of(scene.input->points, edge[0]), number_of(scene.input->points, edge[1])};
    for (std::size_t k = 0; k < 2; ++k)
      if (distance(edge[k], x.on_rim) <= at_corner * scene.delta) ends[1 - k] = ends[k];
    x.edge = ends;
    break;
  }
  return x;
}

std::size_t RimReport::count(HoleState state) const {
  return static_cast<std::size_t>(
      std::count_if(loops.begin(), loops.end(), [&](const LoopReport& l) { return l.state == state; }));
}

std::optional<RimReport> report_rim(const StateSnapshot& state, const Scene& scene) {
  const Rim* rim = open_rim(scene);
  if (rim == nullptr) return std::nullopt;
  RimReport report;
  for (const RimLoop& loop : rim->loops()) report.loops.push_back({loop, HoleState::ahead, {}});
  for (const RimPiece& p : rim->pieces())
    if (p.open) report.loops[p.loop].pieces.push_back({p.a, p.b});
  report.bridged = bridged_stretches(*rim);
  const ZeroCurves curves = zero_curves(state.zero_set);
  const bool cut = !curves.border.empty() || !dropped_facets(state.complex).empty() ||
                   (state.event && comes_after(state.event->stage, Stage::rim));
  if (!cut) return report;
  for (LoopReport& loop : report.loops) loop.state = HoleState::filled;
  const auto place = [&](std::uint32_t v) { return state.zero_set.vertices[v].position; };
  for (const auto& [a, b] : curves.border)
    report.loops[rim->loop_near(0.5 * (place(a) + place(b)))].state = HoleState::kept;
  return report;
}

} // namespace isoscope
