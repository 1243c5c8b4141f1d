// Rounds of splits, each judged in parallel and made in the order of vertices; then one operation drops.
#include "simplify/rim_cut.h"

#include "base/parallel.h"
#include "base/place.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace isoscope {
namespace {

/// Halvings towards the wall on an edge.
constexpr int wall_steps = 50;
constexpr int most_cut_rounds = 60;
/// Vertices at which Z leaves Ω, or ends too far from the rim, with edges too short to be split: more than
/// both of these, the second relative to the facets that are kept, are given up.
constexpr double least_hopeless = 200, hopeless_share = 0.04;
/// Strips of the input between two loops of the rim are looked for on edges at that many steps at most.
/// Stretches of fewer steps, or near to one loop on both sides, are teeth of a jagged rim.
constexpr int least_look_steps = 4;
constexpr int most_look_steps = 100;
constexpr int most_strip_rounds = 8;
/// Facets at an edge that are turned so that it can be split, and how flat they are, relative to it.
constexpr int most_unfoldings = 4;
constexpr double flat = 1e-9;
/// Shorter edges, in units of δ, are not worth that: what is as fine there only becomes finer.
constexpr double least_unfolded = 0.1;

} // namespace

RimCut::RimCut(LiveComplex& live, const ToleranceVolume& volume, StageLog& log)
    : live_(live), volume_(volume), log_(log), proofs_(live, volume) {}

bool RimCut::keeps(Vec3 p) const {
  const ClosestPoint closest = volume_.field().closest(p);
  if (closest.distance() > volume_.thresholds().delta) return false;
  if (is_by_kept_rim(p)) return true;
  return !volume_.open_sides()->is_by_wall(p, closest) &&
         std::none_of(worn_.begin(), worn_.end(),
                      [&](const WornBall& ball) { return distance(ball.center, p) < ball.radius; });
}

/// Vertices of Z that have no place yet get theirs.
void RimCut::classify() {
  const Complex& complex = live_.complex();
  places_.resize(complex.vertices.size(), Place::unknown);
  std::vector<VertexId> fresh;
  for (std::size_t v = 0; v < places_.size(); ++v) {
    const Vertex& vertex = complex.vertices[v];
    if (vertex.alive && vertex.value == 0 && places_[v] == Place::unknown) fresh.push_back(VertexId(v));
  }
  parallel_for(fresh.size(), 64, [&](std::size_t i) {
    places_[fresh[i].index()] = keeps(complex.position(fresh[i])) ? Place::kept : Place::beyond;
  });
}

void RimCut::collect_facets() {
  const Complex& complex = live_.complex();
  facets_.clear();
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    if (!complex.tets[i].alive() || complex.tets[i].side <= 0) continue;
    for (std::size_t k = 0; k < 4; ++k)
      if (complex.on_zero_set(TetId(i), k)) facets_.push_back(sorted(complex.tets[i].facet(k)));
  }
  std::sort(facets_.begin(), facets_.end());
}

std::vector<RimCut::Facet> RimCut::kept_facets() const {
  std::vector<Facet> kept;
  std::copy_if(facets_.begin(), facets_.end(), std::back_inserter(kept),
               [&](const Facet& f) { return keeps_facet(f); });
  return kept;
}

/// Edges with one facet that is kept, ascending.
std::vector<RimCut::Edge> RimCut::border(const std::vector<Facet>& kept) const {
  std::vector<Edge> edges, once;
  for (const Facet& f : kept)
    for (const Edge& e : rim_edges(f)) edges.push_back(e);
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    if (end - i == 1) once.push_back(edges[i]);
  }
  return once;
}

/// Edges from a vertex that is kept, and not on the wall already, to one beyond.
std::vector<RimCut::Edge> RimCut::crossing_edges() const {
  std::vector<Edge> edges;
  for (const Facet& f : facets_)
    for (const auto& [a, b] : rim_edges(f)) {
      const Place pa = places_[a.index()], pb = places_[b.index()];
      const bool crosses =
          (pa == Place::kept && pb == Place::beyond) || (pa == Place::beyond && pb == Place::kept);
      if (crosses && !whole_.contains({a, b}) && !at_end_.contains({a, b})) edges.push_back({a, b});
    }
  sort_unique(edges);
  return edges;
}

Vec3 RimCut::wall_between(Vec3 kept, Vec3 beyond) const {
  for (int i = 0; i < wall_steps; ++i) {
    const Vec3 middle = 0.5 * (kept + beyond);
    (keeps(middle) ? kept : beyond) = middle;
  }
  return kept;
}

/// Where an edge may be split: where it is wanted, then nearer to the kept end at such fractions of the edge
/// that have the bits of a double left, so that no rounding turns the flattest tetrahedron over.
std::vector<Vec3> RimCut::places_on_edge(const Edge& edge, Vec3 at) const {
  const bool second = places_[edge[0].index()] == Place::beyond;
  const Vec3 from = live_.complex().position(edge[second ? 1 : 0]);
  const Vec3 to = live_.complex().position(edge[second ? 0 : 1]);
  const double t = dot(at - from, to - from) / squared_length(to - from);
  std::vector<Vec3> places{at};
  for (const double parts : {256.0, 64.0, 16.0, 8.0, 4.0, 2.0})
    if (const double fraction = std::floor(t * parts) / parts; fraction > 0)
      places.push_back(from + fraction * (to - from));
  if (is_kept(edge[0]) && is_kept(edge[1]))
    for (const double fraction : {0.4375, 0.5625, 0.375, 0.625, 0.25, 0.75})
      places.push_back(from + fraction * (to - from));
  return places;
}

bool RimCut::split(const RimSplit& s, Vec3 at, Place place) {
  const auto [a, b] = s.edge;
  for (int i = 0; i <= most_unfoldings; ++i) {
    if (!live_.adjacent(a, b)) return i > 0; // turned in one of these
    if (split_at(s, at, place)) return true;
    if (!unfold(s)) break;
  }
  whole_.insert(s.edge);
  return false;
}

bool RimCut::split_at(const RimSplit& s, Vec3 at, Place place) {
  const auto [a, b] = s.edge;
  for (const Vec3 p : places_on_edge(s.edge, at)) {
    std::optional<Delta> delta = live_.split(a, b, p);
    if (!delta) continue;
    live_.apply(*delta);
    places_.resize(live_.complex().vertices.size(), Place::unknown);
    places_.back() = place;
    tell(s, p, std::move(*delta));
    return true;
  }
  return false;
}

void RimCut::tell(const RimSplit& s, Vec3 at, Delta delta) {
  Event e;
  e.kind = EventKind::split;
  e.reason = s.reason;
  e.vertex = s.edge[0];
  e.other = s.edge[1];
  e.point = at;
  e.witness = s.witness;
  e.value = s.value;
  e.limit = volume_.thresholds().delta;
  log_.operation(e, std::move(delta), live_.step_figures());
}

/// Where the corners of a facet at an edge lie on a line, up to rounding, all tetrahedra around are flat, and
/// no place on the edge splits them. Its longest edge then falls in two at the third corner, which lies on
/// it: it is turned within its two facets, which leaves Z where it is. False where that is not possible.
bool RimCut::unfold(const RimSplit& s) {
  if (!unfolds_ || length(s.edge) < least_unfolded * volume_.thresholds().delta) return false;
  const Complex& complex = live_.complex();
  const double least = flat * length(s.edge);
  for (const TetId t : live_.incidence().tets_of(s.edge[0])) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Facet f = sorted(complex.tet(t).facet(k));
      const auto has = [&](VertexId v) { return std::find(f.begin(), f.end(), v) != f.end(); };
      if (complex.tet(t).side < 0 || !complex.on_zero_set(t, k) || !has(s.edge[0]) || !has(s.edge[1]) ||
          height(f) > least)
        continue;
      const auto edges = rim_edges(f);
      const Edge longest = *std::max_element(
          edges.begin(), edges.end(), [&](const Edge& x, const Edge& y) { return length(x) < length(y); });
      const VertexId middle =
          *std::find_if(f.begin(), f.end(), [&](VertexId v) { return v != longest[0] && v != longest[1]; });
      std::optional<Delta> delta = live_.flip(longest[0], longest[1]);
      if (!delta) continue;
      live_.apply(*delta);
      std::erase_if(whole_, [&](const Edge& e) { return has(e[0]) || has(e[1]); });
      tell({longest, s.reason, s.witness, s.value}, complex.position(middle), std::move(*delta));
      return true;
    }
  }
  return false;
}

/// Of a facet over its longest edge.
double RimCut::height(const Facet& f) const {
  const auto edges = rim_edges(f);
  double longest = 0;
  for (const Edge& e : edges) longest = std::max(longest, length(e));
  const Vec3 p = live_.complex().position(f[0]);
  const Vec3 area = cross(live_.complex().position(f[1]) - p, live_.complex().position(f[2]) - p);
  return isoscope::length(area) / longest;
}

void RimCut::cut_edges(const std::vector<Edge>& edges) {
  std::vector<Vec3> at(edges.size());
  parallel_for(edges.size(), 8, [&](std::size_t i) {
    const auto [a, b] = edges[i];
    const bool first = places_[a.index()] == Place::kept;
    at[i] = wall_between(live_.complex().position(first ? a : b), live_.complex().position(first ? b : a));
  });
  const double touching = at_wall * volume_.thresholds().delta;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (log_.stopped()) return;
    auto [kept, beyond] = edges[i];
    if (places_[kept.index()] == Place::beyond) std::swap(kept, beyond);
    if (places_[beyond.index()] != Place::beyond) continue; // found to be on the wall
    if (distance(at[i], live_.complex().position(kept)) <= touching)
      at_end_.insert(edges[i]);
    else if (distance(at[i], live_.complex().position(beyond)) <= touching)
      places_[beyond.index()] = Place::wall;
    else
      split({edges[i], Reason::wall_over_rim, at[i], 0}, at[i], Place::wall);
  }
}

/// The middle of the longest stretch between two points beyond that is kept, where it is one of a strip.
std::optional<Vec3> RimCut::strip_between(Vec3 a, Vec3 b) const {
  const double step = look_step * volume_.thresholds().delta;
  const int steps = std::min(most_look_steps, static_cast<int>(std::ceil(distance(a, b) / step)));
  int best = 0, best_end = 0, run = 0;
  for (int k = 1; k < steps; ++k) {
    run = keeps(a + (static_cast<double>(k) / steps) * (b - a)) ? run + 1 : 0;
    if (run > best) best = run, best_end = k;
  }
  const auto at = [&](double k) { return a + (k / steps) * (b - a); };
  const Rim& rim = volume_.open_sides()->rim();
  const Vec3 middle = at(best_end - 0.5 * (best - 1));
  const bool one_loop = rim.loop_near(at(best_end - best + 1)) == rim.loop_near(at(best_end));
  const bool is_strip = best >= least_look_steps &&
                        (!one_loop || rim.curve().distance(middle) > by_rim * volume_.thresholds().delta);
  if (!is_strip && !(best > 0 && is_by_kept_rim(middle))) return std::nullopt;
  return middle;
}

/// Splits edges between places beyond where they cross a strip of the input with a rim on both sides. False
/// when none does.
bool RimCut::find_strips() {
  std::vector<Edge> edges;
  for (const Facet& f : facets_)
    for (const Edge& e : rim_edges(f)) {
      const Place pa = places_[e[0].index()], pb = places_[e[1].index()];
      const bool crosses_wall = (pa == Place::kept || pb == Place::kept) && !at_end_.contains(e);
      if (crosses_wall || (is_kept(e[0]) && is_kept(e[1]))) continue;
      if (!whole_.contains(e) && looked_at_.insert(e).second) edges.push_back(e);
    }
  std::sort(edges.begin(), edges.end());
  std::vector<std::optional<Vec3>> at(edges.size());
  parallel_for(edges.size(), 8, [&](std::size_t i) {
    const auto [a, b] = segment(edges[i]);
    at[i] = strip_between(a, b);
  });
  bool found = false;
  for (std::size_t i = 0; i < edges.size() && !log_.stopped(); ++i)
    if (at[i]) found |= split({edges[i], Reason::wall_over_rim, *at[i], 0}, *at[i], Place::kept);
  return found;
}

/// Both tetrahedra of each facet of Z with a corner beyond say that it is no part of Z.
void RimCut::drop() {
  const Complex& complex = live_.complex();
  Delta delta;
  std::size_t facets = 0;
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    if (!complex.tets[i].alive()) continue;
    unsigned bits = complex.tets[i].dropped;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!complex.on_zero_set(TetId(i), k)) continue;
      const Facet f = complex.tets[i].facet(k);
      if (keeps_facet(f)) continue;
      bits |= 1u << k;
      facets += complex.tets[i].side > 0;
    }
    if (bits != complex.tets[i].dropped)
      delta.dropped.push_back({TetId(i), complex.tets[i].dropped, static_cast<std::uint8_t>(bits)});
  }
  live_.apply(delta);
  Event e;
  e.kind = EventKind::cut;
  e.count = static_cast<std::uint32_t>(facets);
  log_.operation(e, std::move(delta), live_.step_figures());
}

/// Whether Z leaves Ω, or ends too far from the rim, in more places than ways around them are found for.
bool RimCut::is_hopeless(std::size_t kept) const {
  const double most = std::max(least_hopeless, hopeless_share * static_cast<double>(kept));
  return static_cast<double>(proofs_.stuck().size() + proofs_.stuck_border().size()) > most;
}

Status RimCut::run() {
  for (int round = 0; !log_.stopped(); ++round) {
    classify();
    collect_facets();
    cut_edges(crossing_edges());
    collect_facets();
    for (int i = 0; i < most_strip_rounds && find_strips(); ++i) {
      collect_facets();
      cut_edges(crossing_edges());
      collect_facets();
    }
    settle_spare_patches();
    bool changed = join_patches();
    if (cut_pinches()) changed = true;
    if (round >= most_cut_rounds) break;
    const std::vector<Facet> kept = kept_facets();
    const std::vector<Edge> edges = border(kept);
    const std::vector<RimSplit> splits =
        proofs_.wanted_splits({facets_, kept, edges, whole_}, [this](VertexId v) { return is_kept(v); });
    if (is_hopeless(kept.size())) {
      const std::vector<VertexId> stuck = proofs_.stuck(), ends = proofs_.stuck_border();
      const Vec3 p = live_.complex().position(stuck.empty() ? ends.front() : stuck.front());
      return Error{ErrorCode::unsupported,
                   "Z leaves Ω before it is over the rim, in " + std::to_string(stuck.size() + ends.size()) +
                       " places, one of them near " + place(p, place_digits) +
                       ": parts of the surface with a border lie too near to each other for this tolerance.",
                   "Use a smaller tolerance."};
    }
    if (splits.empty()) {
      // What stays outside of Ω however small its parts are does not belong to what is kept.
      const std::vector<VertexId> stuck = proofs_.stuck();
      if (!stuck.empty())
        set_apart(stuck, Place::beyond, Reason::leaves_volume);
      else if (!close_gaps() && !wear_away(proofs_.stuck_border()) && !changed) {
        // Only now, as what is unfolded is split on and on where the border lies well in the end.
        if (unfolds_ || !proofs_.is_border_stuck()) break;
        unfolds_ = true;
        whole_.clear();
      }
    }
    for (const RimSplit& s : splits) {
      if (log_.stopped()) return {};
      const Vec3 middle = 0.5 * (live_.complex().position(s.edge[0]) + live_.complex().position(s.edge[1]));
      split(s, middle, keeps(middle) ? Place::kept : Place::beyond);
    }
  }
  if (!log_.stopped()) drop();
  return {};
}

} // namespace isoscope
