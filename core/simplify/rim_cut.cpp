// Rounds of splits, each judged in parallel and made in the order of vertices; then one operation drops.
#include "simplify/rim_cut.h"

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "base/sort_unique.h"
#include "tolerance/border_gate.h"
#include "tolerance/facet_certificate.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isoscope {
namespace {

/// Halvings towards the wall on an edge.
constexpr int wall_steps = 50;
constexpr int most_cut_rounds = 60;
/// Strips of the input between two loops of the rim are looked for on edges at steps of this, in units of δ,
/// and at so many at most. Stretches of fewer steps, or with one loop on both sides, are teeth of a jagged
/// rim.
constexpr double strip_step = 0.25;
constexpr int least_strip_steps = 4;
constexpr int most_strip_steps = 100;
constexpr int most_strip_rounds = 8;
/// A vertex this near to where an edge crosses the wall is on it, in units of δ.
constexpr double at_wall = 0.01;
/// The longest way along which patches of one loop are joined, in units of δ.
constexpr double longest_way = 3;
/// How far from a pinched vertex its edges are cut, in units of δ.
constexpr double pinch_share = 0.05;
/// A part of what is kept that is smaller than this is a crumb, in units of δ.
constexpr double crumb = 4;

} // namespace

RimCut::RimCut(LiveComplex& live, const ToleranceVolume& volume, StageLog& log)
    : live_(live), volume_(volume), log_(log), proofs_(live, volume) {}

bool RimCut::keeps(Vec3 p) const {
  const ClosestPoint closest = volume_.field().closest(p);
  return closest.distance() <= volume_.thresholds().delta && !volume_.open_sides()->is_by_wall(p, closest);
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
      if (crosses && !whole_.contains({a, b})) edges.push_back({a, b});
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
  return places;
}

bool RimCut::split(const RimSplit& s, Vec3 at, Place place) {
  const auto [a, b] = s.edge;
  for (const Vec3 p : places_on_edge(s.edge, at)) {
    std::optional<Delta> delta = live_.split(a, b, p);
    if (!delta) continue;
    live_.apply(*delta);
    places_.resize(live_.complex().vertices.size(), Place::unknown);
    places_.back() = place;
    Event e;
    e.kind = EventKind::split;
    e.reason = s.reason;
    e.vertex = a;
    e.other = b;
    e.point = p;
    e.witness = s.witness;
    e.value = s.value;
    e.limit = volume_.thresholds().delta;
    log_.operation(e, std::move(*delta), live_.step_figures());
    return true;
  }
  whole_.insert(s.edge);
  return false;
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
      whole_.insert(edges[i]);
    else if (distance(at[i], live_.complex().position(beyond)) <= touching)
      places_[beyond.index()] = Place::wall;
    else
      split({edges[i], Reason::wall_over_rim, at[i], 0}, at[i], Place::wall);
  }
}

/// The middle of the longest stretch between two points beyond that is kept, where it is one of a strip.
std::optional<Vec3> RimCut::strip_between(Vec3 a, Vec3 b) const {
  const double step = strip_step * volume_.thresholds().delta;
  const int steps = std::min(most_strip_steps, static_cast<int>(std::ceil(distance(a, b) / step)));
  int best = 0, best_end = 0, run = 0;
  for (int k = 1; k < steps; ++k) {
    run = keeps(a + (static_cast<double>(k) / steps) * (b - a)) ? run + 1 : 0;
    if (run > best) best = run, best_end = k;
  }
  const auto at = [&](double k) { return a + (k / steps) * (b - a); };
  const Rim& rim = volume_.open_sides()->rim();
  if (best < least_strip_steps || rim.loop_near(at(best_end - best + 1)) == rim.loop_near(at(best_end)))
    return std::nullopt;
  return at(best_end - 0.5 * (best - 1));
}

/// Splits edges between places beyond where they cross a strip of the input with a rim on both sides. False
/// when none does.
bool RimCut::find_strips() {
  std::vector<Edge> edges;
  for (const Facet& f : facets_)
    for (const Edge& e : rim_edges(f)) {
      const Place pa = places_[e[0].index()], pb = places_[e[1].index()];
      if (pa == Place::kept || pb == Place::kept || (pa == Place::wall && pb == Place::wall)) continue;
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

/// Whether some place of the rim has no border within δ but that of the patch.
bool RimCut::rim_needs(const RimPatch& patch, const std::vector<RimPatch>& all) const {
  const double delta = volume_.thresholds().delta;
  Box3 box;
  std::vector<Segment3> own, others;
  for (const Edge& e : patch.border) {
    own.push_back(segment(e));
    for (const Vec3 p : own.back()) box.add(p);
  }
  const double near = 0.5 * distance(box.lo, box.hi) + 2 * delta;
  // Each border edge is one of a patch that is kept and of one that is not.
  for (const RimPatch& other : all) {
    if (other.kept != patch.kept || &other == &patch) continue;
    for (const Edge& e : other.border)
      if (distance_to(segment(e), box.center()) <= near) others.push_back(segment(e));
  }
  return !volume_.border_gate()->covers_rim(own, others).proven;
}

bool RimCut::lies_inside(const RimPatch& patch) const {
  const double delta = volume_.thresholds().delta;
  const Complex& complex = live_.complex();
  const auto is_inside = [&](std::uint32_t i) {
    const Facet& f = facets_[i];
    const Triangle3 t{complex.position(f[0]), complex.position(f[1]), complex.position(f[2])};
    return certify_facet(volume_.field(), t, delta, delta, rim_piece_budget).kind ==
           FacetVerdict::Kind::inside;
  };
  return std::all_of(patch.facets.begin(), patch.facets.end(), is_inside);
}

bool RimCut::is_crumb(const RimPatch& patch) const {
  Box3 box;
  for (const std::uint32_t i : patch.facets)
    for (const VertexId v : facets_[i]) box.add(live_.complex().position(v));
  return distance(box.lo, box.hi) <= crumb * volume_.thresholds().delta;
}

std::vector<RimPatch> RimCut::patches() const {
  std::vector<std::uint8_t> kept(facets_.size());
  for (std::size_t i = 0; i < facets_.size(); ++i) kept[i] = keeps_facet(facets_[i]) ? 1 : 0;
  return rim_patches(facets_, kept);
}

void RimCut::settle_spare_patches() {
  const std::vector<RimPatch> all = patches();
  for (const RimPatch& patch : all) {
    if (log_.stopped()) return;
    if (patch.border.empty() || !(patch.kept ? is_crumb(patch) : lies_inside(patch)) || rim_needs(patch, all))
      continue;
    turn(patch);
  }
}

/// Drops what is kept, keeps what is dropped.
void RimCut::turn(const RimPatch& patch) {
  for (const std::uint32_t i : patch.facets)
    for (const VertexId v : facets_[i])
      if (patch.kept)
        places_[v.index()] = Place::beyond;
      else if (!is_kept(v))
        places_[v.index()] = Place::kept;
}

/// By loop of the rim: how much of the patch's border is nearest to it.
std::vector<double> RimCut::lengths_by_loop(const RimPatch& patch) const {
  const Rim& rim = volume_.open_sides()->rim();
  std::vector<double> lengths(rim.loops().size(), 0);
  for (const Edge& e : patch.border) lengths[rim.loop_near(point_on(segment(e), 0.5))] += length(e);
  return lengths;
}

/// One loop of the rim makes one patch that is dropped and has one that is kept: others are joined to the
/// largest of their kind where the way is short; crumbs for which there is none are dropped.
void RimCut::join_patches() {
  for (bool again = true; again && !log_.stopped();) {
    again = false;
    const std::vector<RimPatch> all = patches();
    std::vector<std::vector<double>> lengths;
    for (const RimPatch& patch : all) lengths.push_back(lengths_by_loop(patch));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto longest = std::max_element(lengths[i].begin(), lengths[i].end());
      if (longest == lengths[i].end() || *longest == 0) continue;
      const auto loop = static_cast<std::size_t>(longest - lengths[i].begin());
      std::vector<const RimPatch*> larger;
      for (std::size_t k = 0; k < all.size(); ++k)
        if (all[k].kept == all[i].kept && lengths[k][loop] > *longest) larger.push_back(&all[k]);
      if (larger.empty()) continue;
      bool changed = join(all[i], larger);
      again = changed && patches().size() < all.size();
      if (!again && all[i].kept && is_crumb(all[i])) {
        turn(all[i]);
        changed = true;
        again = patches().size() < all.size();
      }
      if (changed) break; // the patches are others now; without progress they wait for the next round
    }
  }
}

/// Holes by a channel, crumbs by what lies around the way, as far as it is in Ω.
bool RimCut::join(const RimPatch& patch, const std::vector<const RimPatch*>& to) {
  const auto vertices_of = [](const std::vector<Edge>& border, std::vector<VertexId>& vertices) {
    for (const Edge& e : border) vertices.insert(vertices.end(), e.begin(), e.end());
    sort_unique(vertices);
  };
  std::vector<VertexId> from, ends;
  vertices_of(patch.border, from);
  for (const RimPatch* other : to) vertices_of(other->border, ends);
  const auto is_in_volume = [&](VertexId v) {
    return volume_.field().distance(live_.complex().position(v)) <= volume_.thresholds().delta;
  };
  const auto is_allowed = [&](VertexId v) {
    return is_kept(v) != patch.kept && (is_kept(v) || is_in_volume(v));
  };
  const auto apart = [&](VertexId a, VertexId b) {
    return distance(live_.complex().position(a), live_.complex().position(b));
  };
  const std::vector<VertexId> way =
      shortest_way(facets_, from, ends, is_allowed, apart, longest_way * volume_.thresholds().delta);
  if (way.empty() || (patch.kept && way.size() < 3)) return false;
  if (!patch.kept) {
    take_away(way);
    return true;
  }
  const auto is_between = [&](VertexId v) {
    return std::find(way.begin() + 1, way.end() - 1, v) < way.end() - 1;
  };
  for (const Facet& f : facets_)
    if (std::any_of(f.begin(), f.end(), is_between))
      for (const VertexId v : f)
        if (!is_kept(v) && is_in_volume(v)) places_[v.index()] = Place::kept;
  return true;
}

/// Vertices at which what is kept has more than one fan, ascending.
std::vector<VertexId> RimCut::pinches() const {
  std::vector<std::pair<VertexId, Edge>> links; // by vertex: the edges of kept facets opposite to it
  for (const Facet& f : kept_facets())
    for (std::size_t k = 0; k < 3; ++k) links.push_back({f[k], sorted(Edge{f[(k + 1) % 3], f[(k + 2) % 3]})});
  std::sort(links.begin(), links.end());
  std::vector<VertexId> found;
  for (std::size_t i = 0, end = 0; i < links.size(); i = end) {
    while (end < links.size() && links[end].first == links[i].first) ++end;
    std::vector<VertexId> around;
    for (std::size_t k = i; k < end; ++k)
      around.insert(around.end(), links[k].second.begin(), links[k].second.end());
    sort_unique(around);
    DisjointSets fans(around.size());
    std::size_t count = around.size();
    const auto number = [&](VertexId v) {
      return static_cast<std::uint32_t>(std::lower_bound(around.begin(), around.end(), v) - around.begin());
    };
    for (std::size_t k = i; k < end; ++k)
      count -= fans.unite(number(links[k].second[0]), number(links[k].second[1]));
    if (count > 1) found.push_back(links[i].first);
  }
  return found;
}

/// Takes vertices away from what is kept, with a little of their edges to what stays.
void RimCut::take_away(std::span<const VertexId> vertices) {
  for (const VertexId v : vertices) places_[v.index()] = Place::beyond;
  for (const VertexId v : vertices) {
    std::vector<VertexId> around;
    for (const Facet& f : facets_)
      if (std::find(f.begin(), f.end(), v) != f.end())
        for (const VertexId x : f)
          if (is_kept(x)) around.push_back(x);
    sort_unique(around);
    for (const VertexId x : around) {
      if (log_.stopped()) return;
      const Vec3 from = live_.complex().position(v), to = live_.complex().position(x);
      const double share = std::min(0.5, pinch_share * volume_.thresholds().delta / distance(from, to));
      split({sorted(Edge{v, x}), Reason::pinched_border, from, 0}, from + share * (to - from), Place::wall);
    }
    collect_facets();
  }
}

void RimCut::cut_pinches() {
  for (const VertexId v : pinches())
    if (!log_.stopped()) take_away(std::array{v});
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

void RimCut::run() {
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
    join_patches();
    cut_pinches();
    if (round >= most_cut_rounds) break;
    const std::vector<Facet> kept = kept_facets();
    const std::vector<Edge> edges = border(kept);
    const std::vector<RimSplit> splits =
        proofs_.wanted_splits({facets_, kept, edges, whole_}, [this](VertexId v) { return is_kept(v); });
    if (splits.empty()) {
      // What stays outside of Ω however small its parts are does not belong to what is kept.
      const std::vector<VertexId> stuck = proofs_.stuck();
      if (stuck.empty()) break;
      take_away(stuck);
    }
    for (const RimSplit& s : splits) {
      if (log_.stopped()) return;
      const Vec3 middle = 0.5 * (live_.complex().position(s.edge[0]) + live_.complex().position(s.edge[1]));
      split(s, middle, keeps(middle) ? Place::kept : Place::beyond);
    }
  }
  if (!log_.stopped()) drop();
}

} // namespace isoscope
