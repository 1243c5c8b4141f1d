// Holes and crumbs where the wall dips into the sheet, gaps before the rim, parts that meet in a vertex, and
// what lies too far from the rim: mended among the vertices of Z, with few splits.
#include "simplify/rim_cut.h"

#include "base/disjoint_sets.h"
#include "base/sort_unique.h"
#include "tolerance/border_gate.h"
#include "tolerance/facet_certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope {
namespace {

/// Radii of what is taken away where the border is too far from the rim, in units of δ.
constexpr double least_worn = 0.1, most_worn = 0.2;
/// What is taken where Z leaves Ω before it is over the rim is farther than that from it, and lies within so
/// much around a place of the border, in units of δ; halvings towards its end on an edge.
constexpr double flap_edge = 0.95, flap_reach = 2;
constexpr int level_steps = 30;
/// How far from a vertex that is taken its edges are cut, in units of δ.
constexpr double pinch_share = 0.05;
/// A part of what is kept that is smaller than this is a crumb, in units of δ.
constexpr double crumb = 4;

} // namespace

/// Where Z leaves Ω before it is over the rim its border may be too far from that. What is so far from the
/// rim there is taken away where it is a flap, that ends nearer to the rim all around; else balls around such
/// vertices are, larger ones where smaller ones did not do. False where nothing is.
bool RimCut::wear_away(std::span<const VertexId> vertices) {
  const double delta = volume_.thresholds().delta;
  const std::size_t before = worn_.size();
  bool any = false;
  for (const VertexId v : vertices) {
    if (!is_kept(v)) continue; // with a flap
    if (take_flap(v)) {
      any = true;
      continue;
    }
    const Vec3 p = live_.complex().position(v);
    double radius = least_worn * delta;
    bool fresh = true;
    for (std::size_t i = 0; i < worn_.size(); ++i) {
      const double d = distance(worn_[i].center, p);
      if (i < before && d <= worn_[i].radius + at_wall * delta)
        radius = std::max(radius, 2 * worn_[i].radius);
      fresh &= i < before || d >= worn_[i].radius;
    }
    if (fresh && radius <= most_worn * delta) worn_.push_back({p, radius});
  }
  for (std::size_t v = 0; v < places_.size(); ++v)
    if (is_kept(VertexId(v)))
      for (std::size_t i = before; i < worn_.size(); ++i)
        if (distance(worn_[i].center, live_.complex().position(VertexId(v))) < worn_[i].radius)
          places_[v] = Place::beyond;
  return any || worn_.size() > before;
}

/// Takes away what is kept and farther than 0.95 δ from the rim around a vertex of the border, where that
/// does not go on into the sheet.
bool RimCut::take_flap(VertexId start) {
  const double delta = volume_.thresholds().delta;
  const ClosestPointIndex& curve = volume_.open_sides()->rim().curve();
  const auto is_far = [&](Vec3 p) { return curve.distance(p) > flap_edge * delta; };
  const Complex& complex = live_.complex();
  std::vector<VertexId> flap{start};
  std::set<Edge> edges; // from it to what stays
  for (std::size_t i = 0; i < flap.size(); ++i) {
    if (distance(complex.position(flap[i]), complex.position(start)) > flap_reach * delta) return false;
    for (const VertexId n : live_.neighbors(flap[i])) {
      if (complex.value(n) != 0 || !is_kept(n) || std::find(flap.begin(), flap.end(), n) != flap.end())
        continue;
      if (is_far(complex.position(n)))
        flap.push_back(n);
      else
        edges.insert({flap[i], n});
    }
  }
  for (const VertexId v : flap) places_[v.index()] = Place::beyond;
  for (const auto& [far, near] : edges) {
    if (log_.stopped()) return true;
    Vec3 in = complex.position(near), out = complex.position(far);
    for (int i = 0; i < level_steps; ++i) {
      const Vec3 middle = 0.5 * (in + out);
      (is_far(middle) ? out : in) = middle;
    }
    const Edge edge = sorted(Edge{far, near});
    if (distance(in, complex.position(near)) <= at_wall * delta ||
        !split({edge, Reason::border_off_rim, in, 0}, in, Place::wall))
      at_end_.insert(edge);
  }
  collect_facets();
  return true;
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

/// Whether all of a patch is proven to be within δ by a field.
bool RimCut::lies_within(const RimPatch& patch, const ToleranceField& field) const {
  const double delta = volume_.thresholds().delta;
  const Complex& complex = live_.complex();
  const auto is_within = [&](std::uint32_t i) {
    const Facet& f = facets_[i];
    const Triangle3 t{complex.position(f[0]), complex.position(f[1]), complex.position(f[2])};
    return certify_facet(field, t, delta, delta, rim_piece_budget).kind == FacetVerdict::Kind::inside;
  };
  return std::all_of(patch.facets.begin(), patch.facets.end(), is_within);
}

bool RimCut::is_crumb(const RimPatch& patch) const {
  if (lies_within(patch, volume_.open_sides()->rim().curve())) return true;
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

/// One after the other: of two that cover the same of the rim one may go.
void RimCut::settle_spare_patches() {
  std::vector<RimPatch> all = patches();
  for (std::size_t i = 0; i < all.size() && !log_.stopped(); ++i) {
    const RimPatch& patch = all[i];
    if (patch.border.empty() || !(patch.kept ? is_crumb(patch) : lies_within(patch, volume_.field())) ||
        rim_needs(patch, all))
      continue;
    turn(patch);
    all[i].border.clear();
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
/// largest of their kind where the way is short; crumbs for which there is none are dropped. True where
/// edges were split or more is kept so that there may be one the next time.
bool RimCut::join_patches() {
  bool prepared = false;
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
      if (!again && all[i].kept && follows_rim(all[i])) {
        if (!changed) changed = refine_between(all[i], larger) || follow_rim_on(all[i]);
        prepared |= changed;
      } else if (!again && all[i].kept && is_crumb(all[i])) {
        turn(all[i]);
        changed = true;
        again = patches().size() < all.size();
      }
      if (changed) break; // the patches are others now; without progress they wait for the next round
    }
  }
  return prepared;
}

bool RimCut::is_in_volume(VertexId v) const {
  return volume_.field().distance(live_.complex().position(v)) <= volume_.thresholds().delta;
}

/// Near enough for what lies beside it to be within δ of the rim.
bool RimCut::is_near_rim(VertexId v) const {
  return volume_.open_sides()->rim().curve().distance(live_.complex().position(v)) <=
         by_rim * volume_.thresholds().delta;
}

/// The length of an edge that is as near to the rim all along, else more than any way.
double RimCut::length_by_rim(const Edge& e) const {
  const double delta = volume_.thresholds().delta;
  const int steps = static_cast<int>(std::ceil(length(e) / (look_step * delta)));
  for (int k = 1; k < steps; ++k)
    if (volume_.open_sides()->rim().curve().distance(point_on(segment(e), static_cast<double>(k) / steps)) >
        by_rim * delta)
      return std::numeric_limits<double>::infinity();
  return length(e);
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
  const auto is_allowed = [&](VertexId v) {
    return is_kept(v) != patch.kept && is_near_rim(v) &&
           (is_kept(v) ? !is_by_kept_rim(live_.complex().position(v)) : is_in_volume(v));
  };
  const auto apart = [this](VertexId a, VertexId b) { return length_by_rim({a, b}); };
  const std::vector<VertexId> way =
      shortest_way(facets_, from, ends, is_allowed, apart, longest_way * volume_.thresholds().delta);
  if (way.empty() || (patch.kept && way.size() < 2)) return false;
  if (!patch.kept) {
    set_apart(way, Place::beyond, Reason::pinched_border);
    return true;
  }
  const auto is_beside = [&](const Facet& f) {
    const auto on_way = std::count_if(
        f.begin(), f.end(), [&](VertexId v) { return std::find(way.begin(), way.end(), v) != way.end(); });
    const bool between = std::any_of(way.begin() + 1, way.end() - 1,
                                     [&](VertexId v) { return std::find(f.begin(), f.end(), v) != f.end(); });
    return between || (way.size() == 2 && on_way == 2);
  };
  for (const Facet& f : facets_)
    if (is_beside(f))
      for (const VertexId v : f)
        if (!is_kept(v) && is_in_volume(v)) places_[v.index()] = Place::kept;
  // What lies beside the way outside of Ω is cut off.
  set_apart(way, Place::kept, Reason::pinched_border);
  return true;
}

/// Vertices of the border, ascending, by whether it is nearest to a loop of the rim: those of it, the others.
std::array<std::vector<VertexId>, 2> RimCut::border_by_loop(std::uint32_t loop) const {
  std::array<std::vector<VertexId>, 2> vertices;
  for (const Edge& e : border(kept_facets())) {
    const bool other = volume_.open_sides()->rim().loop_near(point_on(segment(e), 0.5)) != loop;
    vertices[other].insert(vertices[other].end(), e.begin(), e.end());
  }
  for (auto& list : vertices) sort_unique(list);
  return vertices;
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

/// Takes vertices away from what is kept, or adds them to it, with a little of their edges to what stays.
void RimCut::set_apart(std::span<const VertexId> vertices, Place place, Reason reason) {
  for (const VertexId v : vertices) places_[v.index()] = place;
  for (const VertexId v : vertices) {
    std::vector<VertexId> around;
    for (const Facet& f : facets_)
      if (std::find(f.begin(), f.end(), v) != f.end())
        for (const VertexId x : f)
          if (is_kept(x) != is_kept(v)) around.push_back(x);
    sort_unique(around);
    for (const VertexId x : around) {
      if (log_.stopped()) return;
      const Vec3 from = live_.complex().position(v), to = live_.complex().position(x);
      const double share = pinch_share * volume_.thresholds().delta / distance(from, to);
      const Edge edge = sorted(Edge{v, x});
      // Halves of short edges end up as fine as doubles are.
      if (share > 0.5 || !split({edge, reason, from, 0}, from + share * (to - from), Place::wall))
        at_end_.insert(edge);
    }
    collect_facets();
  }
}

/// Two parts that meet in a vertex are parted there; between the holes of two loops what is kept is widened.
/// False where there are none.
bool RimCut::cut_pinches() {
  const std::vector<VertexId> found = pinches();
  for (const VertexId v : found) {
    if (log_.stopped()) break;
    const bool widen = is_in_volume(v) &&
                       (!is_near_rim(v) || is_by_kept_rim(live_.complex().position(v)) || parts_loops(v)) &&
                       widened_.insert(v).second;
    set_apart(std::array{v}, widen ? Place::kept : Place::beyond, Reason::pinched_border);
  }
  return !found.empty();
}

/// Whether holes of different loops meet in a vertex.
bool RimCut::parts_loops(VertexId v) const {
  std::vector<std::size_t> loops;
  for (const RimPatch& patch : patches()) {
    const auto touches = [&](std::uint32_t i) {
      return std::find(facets_[i].begin(), facets_[i].end(), v) != facets_[i].end();
    };
    if (patch.kept || std::none_of(patch.facets.begin(), patch.facets.end(), touches)) continue;
    const std::vector<double> lengths = lengths_by_loop(patch);
    loops.push_back(
        static_cast<std::size_t>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin()));
  }
  sort_unique(loops);
  return loops.size() > 1;
}

} // namespace isoscope
