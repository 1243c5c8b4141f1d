// Places of the rim that no border is near to: it is led there, by a channel in what is kept, or by keeping
// what is near to the rim.
#include "simplify/rim_cut.h"

#include "base/sort_unique.h"

#include <algorithm>
#include <array>

namespace isoscope {
namespace {

/// The longest channel to a gap, in units of δ.
constexpr double longest_channel = 5;
/// Gaps this near to each other, in units of δ, are one, and one is tried to be closed so often.
constexpr double near_gap = 0.25;
constexpr int most_tries = 3;
/// Ways to a gap pass along edges up to that length; longer ones so near to it are split. In units of δ.
constexpr double way_edge = 0.5, way_reach = 1;
/// How far along the rim what is near to it is kept beside a gap, in units of δ.
constexpr double tongue_reach = 1.2;
/// Halvings for one gap.
constexpr int most_refinements = 6;

} // namespace

/// True where some gap was closed. Those near to it look again.
bool RimCut::close_gaps() {
  const double delta = volume_.thresholds().delta;
  std::vector<Vec3> closed;
  const auto count_near = [](const std::vector<Vec3>& places, Vec3 p, double reach) {
    return std::count_if(places.begin(), places.end(), [&](Vec3 q) { return distance(p, q) <= reach; });
  };
  for (const RimGap& gap : proofs_.gaps()) {
    if (log_.stopped()) return false;
    if (count_near(tried_gaps_, gap.place, near_gap * delta) >= most_tries ||
        count_near(closed, gap.place, longest_channel * delta) > 0)
      continue;
    tried_gaps_.push_back(gap.place);
    if (close_gap(gap)) closed.push_back(gap.place);
  }
  return !closed.empty();
}

/// Where Z is kept or beyond all around a place of the rim: leads the border there along the rim, by a
/// channel or a tongue. What is kept and has no hole of that loop yet gets one. Without a way along edges
/// these are halved from there to the border.
bool RimCut::close_gap(const RimGap& gap) {
  if (!is_kept(gap.vertex)) return follow_rim(gap);
  bool refined = false;
  for (int i = 0; i < most_refinements && !log_.stopped(); ++i) {
    const std::vector<VertexId> way = channel_to(gap);
    if (!way.empty()) {
      set_apart(way, Place::beyond, Reason::rim_off_border);
      return true;
    }
    if (!refine_around(gap)) break;
    refined = true;
  }
  return refined;
}

/// The vertices of a channel to a place of the rim, from there on; none where edges do not allow it.
std::vector<VertexId> RimCut::channel_to(const RimGap& gap) const {
  const auto [ends, others] = border_by_loop(volume_.open_sides()->rim().loop_near(gap.place));
  const auto is_free = [&, &others = others](VertexId v) {
    return is_kept(v) && !std::binary_search(others.begin(), others.end(), v) && is_near_rim(v);
  };
  if (!is_free(gap.vertex)) return {};
  if (ends.empty()) return {gap.vertex};
  const auto apart = [this](VertexId a, VertexId b) { return length_by_rim({a, b}); };
  return shortest_way(facets_, std::array{gap.vertex}, ends, is_free, apart,
                      longest_channel * volume_.thresholds().delta);
}

/// Where Z is over the rim, though it passes by a place of it: keeps what is near to the rim there and a
/// little further along it, by places, so that whatever is split there later is judged alike. False where Z
/// is too far away, or all of that is kept.
bool RimCut::follow_rim(const RimGap& gap) {
  const double delta = volume_.thresholds().delta;
  const double radius = distance(gap.place, live_.complex().position(gap.vertex)) + tongue * delta;
  return radius <= by_rim * delta && keep_by_rim(std::array{gap.place}, radius);
}

/// Further along the rim from what is kept so and hangs together with nothing yet.
bool RimCut::follow_rim_on(const RimPatch& patch) {
  const ClosestPointIndex& curve = volume_.open_sides()->rim().curve();
  std::vector<Vec3> from;
  double radius = 0;
  for (const Edge& e : patch.border) {
    from.push_back(point_on(segment(e), 0.5));
    radius = std::max(radius, kept_by_rim_[curve.closest(from.back()).triangle.index()]);
  }
  return keep_by_rim(from, radius);
}

/// What is nearer to the rim than a radius, as far along it as some places reach. False where all of that is
/// kept.
bool RimCut::keep_by_rim(std::span<const Vec3> places, double radius) {
  const double delta = volume_.thresholds().delta;
  const Rim& rim = volume_.open_sides()->rim();
  kept_by_rim_.resize(rim.curve().size(), 0);
  const std::uint32_t loop = rim.loop_near(places.front());
  for (std::size_t i = 0; i < kept_by_rim_.size(); ++i) {
    if (kept_by_rim_[i] >= radius) continue;
    const Triangle3& piece = rim.curve().triangle(TriangleId(i));
    const Vec3 middle = 0.5 * (piece[0] + piece[1]);
    const auto is_near = [&](Vec3 p) { return distance(middle, p) <= tongue_reach * delta; };
    if (std::any_of(places.begin(), places.end(), is_near) && rim.loop_near(middle) == loop)
      kept_by_rim_[i] = radius;
  }
  looked_at_.clear();
  bool any = false;
  for (std::size_t v = 0; v < places_.size(); ++v)
    if (places_[v] == Place::beyond && is_in_volume(VertexId(v)) &&
        is_by_kept_rim(live_.complex().position(VertexId(v)))) {
      places_[v] = Place::kept;
      any = true;
    }
  return any;
}

/// Whether some of a patch is kept as it is near to the rim.
bool RimCut::follows_rim(const RimPatch& patch) const {
  return std::any_of(patch.facets.begin(), patch.facets.end(), [&](std::uint32_t i) {
    return std::any_of(facets_[i].begin(), facets_[i].end(),
                       [&](VertexId v) { return is_by_kept_rim(live_.complex().position(v)); });
  });
}

bool RimCut::is_by_kept_rim(Vec3 p) const {
  if (kept_by_rim_.empty()) return false;
  const ClosestPoint closest = volume_.open_sides()->rim().curve().closest(p);
  return closest.distance() < kept_by_rim_[closest.triangle.index()];
}

/// Halves long edges from a place of the rim to the border, so that ways have where to pass. False where
/// there are none.
bool RimCut::refine_around(const RimGap& gap) {
  double reach = longest_channel * volume_.thresholds().delta;
  for (const Edge& e : border(kept_facets())) reach = std::min(reach, distance_to(segment(e), gap.place));
  return refine_around(gap.place, reach);
}

/// The same from a patch to others.
bool RimCut::refine_between(const RimPatch& patch, std::span<const RimPatch* const> others) {
  const double limit = longest_way * volume_.thresholds().delta;
  double reach = limit;
  Vec3 from;
  for (const Edge& a : patch.border)
    for (const RimPatch* other : others)
      for (const Edge& b : other->border)
        if (const double d = distance_to(segment(b), point_on(segment(a), 0.5)); d < reach) {
          reach = d;
          from = point_on(segment(a), 0.5);
        }
  return reach < limit && refine_around(from, reach);
}

bool RimCut::refine_around(Vec3 p, double reach) {
  const double delta = volume_.thresholds().delta;
  std::vector<Edge> edges;
  for (const Facet& f : facets_)
    for (const Edge& e : rim_edges(f))
      if (is_kept(e[0]) == is_kept(e[1]) && length(e) > way_edge * delta &&
          distance_to(segment(e), p) <= reach + way_reach * delta)
        edges.push_back(e);
  sort_unique(edges);
  bool any = false;
  for (const Edge& e : edges) {
    if (log_.stopped()) return false;
    const Vec3 middle = point_on(segment(e), 0.5);
    any |= split({e, Reason::rim_off_border, p, 0}, middle, keeps(middle) ? Place::kept : Place::beyond);
  }
  collect_facets();
  return any;
}

} // namespace isoscope
