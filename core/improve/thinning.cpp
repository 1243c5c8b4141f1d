// Sweeps over the vertices with edges that may be twice as long each time.
#include "improve/thinning.h"

#include "improve/corner_table.h"
#include "improve/sheet_cells.h"
#include "tolerance/rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isoscope {
namespace {

/// In δ: what is proven of changed facets, and how long their edges may be.
constexpr double largest_reach = 0.95, longest_thinned = 1.34;
constexpr int sweeps_of_level = 2;
constexpr int most_levels_of_thinning = 24;
/// Of a changed facet's height to its longest edge; less only where there was less.
constexpr double least_height = 0.15;
/// Neighbours of a vertex into which it is tried to merge it.
constexpr std::size_t most_tries = 3;
/// A vertex does not get more neighbours.
constexpr std::size_t most_neighbors = 10;

struct Neighbor {
  double cost;
  std::uint32_t corner; ///< of the vertex that goes; the neighbour is at the next one
  friend bool operator<(const Neighbor& a, const Neighbor& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.corner < b.corner;
  }
};

double height_ratio(const Triangle3& t) {
  const double longest =
      std::max({squared_length(t[1] - t[0]), squared_length(t[2] - t[1]), squared_length(t[0] - t[2])});
  return longest > 0 ? 2 * area(t) / longest : 0;
}

class Thinner {
 public:
  Thinner(const TriangleMesh& mesh, const ThinningGround& ground, const RunControl& control,
          ImproverObserver& observer)
      : points_(mesh.points), ground_(ground), control_(control), observer_(observer),
        table_(mesh.triangles, mesh.points.size()), frozen_(mesh.points.size(), 0),
        reach_(mesh.points.size(), unknown), seen_(mesh.points.size(), 0) {
    for (const Vec3 p : points_) box_.add(p);
    rounding_ = rounding_bound(ground.field.bounds(), box_, bound_roundings);
    freeze();
  }

  ThinnedMesh run() {
    const double longest = longest_thinned * ground_.delta;
    int level = 0;
    for (const double mean = mean_edge(); level < most_levels_of_thinning; ++level)
      if (std::ldexp(longest, -level) < 2 * mean) break;
    for (; level >= 0 && !result_.stopped && !control_.cancelled(); --level)
      pass(std::ldexp(longest, -level));
    return compacted();
  }

 private:
  static constexpr float unknown = -1;

  Triangle3 triangle(const std::array<std::uint32_t, 3>& f) const {
    return {points_[f[0]], points_[f[1]], points_[f[2]]};
  }
  bool holds(const std::array<std::uint32_t, 3>& f) const {
    return !ground_.box ||
           std::all_of(f.begin(), f.end(), [&](std::uint32_t v) { return ground_.box->holds(points_[v]); });
  }
  void freeze() {
    for (std::size_t f = 0; f < table_.facets(); ++f)
      if (const auto corners = table_.facet(f); !holds(corners))
        for (const std::uint32_t v : corners) frozen_[v] = 1;
  }
  /// Of the facets that may change.
  double mean_edge() const {
    double sum = 0, count = 0;
    for (std::size_t f = 0; f < table_.facets(); ++f) {
      const auto corners = table_.facet(f);
      if (!holds(corners)) continue;
      const Triangle3 t = triangle(corners);
      sum += distance(t[0], t[1]) + distance(t[1], t[2]) + distance(t[2], t[0]);
      count += 3;
    }
    return count > 0 ? sum / count : Box3::inf;
  }

  /// At most what a vertex is away from the input.
  double reach(std::uint32_t v) {
    if (reach_[v] == unknown) {
      const ClosestPoint closest = ground_.field.closest_near(points_[v], near_);
      near_ = closest.triangle;
      reach_[v] = std::nextafter(static_cast<float>(closest.distance() + rounding_),
                                 std::numeric_limits<float>::infinity());
    }
    return static_cast<double>(reach_[v]);
  }

  void pass(double longest);
  void make_cells(double longest);
  /// Fills star_, ring_ and around_ with what is at a vertex; false where it cannot go.
  bool look_at(std::uint32_t v, double longest);
  void try_to_remove(std::uint32_t v, double longest);
  bool link_condition(std::uint32_t v, std::uint32_t into);
  bool fits(std::uint32_t v, const Neighbor& into, DirectionSet allowed);
  void commit(std::uint32_t v, const Neighbor& into, double distance);
  ThinnedMesh compacted();

  const std::vector<Vec3>& points_;
  const ThinningGround& ground_;
  const RunControl& control_;
  ImproverObserver& observer_;
  CornerTable table_;
  Box3 box_;
  double rounding_ = 0;
  std::vector<std::uint8_t> frozen_;
  std::vector<float> reach_;
  std::vector<std::uint32_t> seen_; ///< by vertex: when it was met last
  std::uint32_t now_ = 0;
  TriangleId near_;
  SheetCells cells_{1};
  // What lies around the vertex at hand.
  std::vector<std::uint32_t> star_, ring_, others_, of_common_;
  std::vector<Neighbor> neighbors_;
  double radius_ = 0;        ///< of its star
  double enough_height_ = 0; ///< of a changed facet
  Box3 around_;
  ThinnedMesh result_;
};

void Thinner::make_cells(double longest) {
  cells_ = SheetCells(std::exp2(std::ceil(std::log2(longest))));
  if (!cells_.fits(box_)) return;
  SparsePoll poll(control_);
  for (std::uint32_t v = 0; v < points_.size() && !poll.cancelled(); ++v)
    if (look_at(v, longest)) cells_.add(cells_.range(around_));
  for (std::size_t f = 0; f < table_.facets() && !poll.cancelled(); ++f)
    if (table_.alive(f)) cells_.restrict(triangle(table_.facet(f)));
  // Regions deeper than δ lie out of reach, but points of thin parts may lie anywhere.
  for (const Vec3 p : ground_.kept) cells_.restrict(cells_.range({p, p}), 0);
}

void Thinner::pass(double longest) {
  make_cells(longest);
  SparsePoll poll(control_);
  for (int sweep = 0; sweep < sweeps_of_level; ++sweep)
    for (std::uint32_t v = 0; v < points_.size() && !result_.stopped && !poll.cancelled(); ++v)
      if (look_at(v, longest)) try_to_remove(v, longest);
}

bool Thinner::look_at(std::uint32_t v, double longest) {
  if (frozen_[v] != 0 || !table_.has_facets(v)) return false;
  table_.star(v, star_);
  if (star_.size() < 3) return false;
  around_ = {points_[v], points_[v]};
  ring_.clear();
  double squared = 0;
  for (const std::uint32_t c : star_) {
    const std::uint32_t w = table_.vertex(CornerTable::next(c));
    ring_.push_back(w);
    around_.add(points_[w]);
    squared = std::max(squared, squared_length(points_[w] - points_[v]));
  }
  radius_ = std::sqrt(squared);
  return radius_ <= longest;
}

void Thinner::try_to_remove(std::uint32_t v, double longest) {
  // All that changes lies in the hull of the star, and each point of that is at most radius / √2 from some
  // vertex of it: so far are the facets from the input, and so deep is all that changes side.
  double reached = reach(v);
  for (const std::uint32_t w : ring_) reached = std::max(reached, reach(w));
  reached += radius_ / std::sqrt(2.) * (1 + 1e-9) + rounding_;
  if (!(reached <= largest_reach * ground_.delta)) return;
  const DirectionSet allowed = cells_.common(cells_.range(around_));
  if (allowed == 0) return;
  neighbors_.clear();
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    double squared = 0;
    for (const std::uint32_t w : ring_)
      squared = std::max(squared, squared_length(points_[w] - points_[ring_[i]]));
    if (squared <= longest * longest) neighbors_.push_back({squared, star_[i]});
  }
  enough_height_ = least_height;
  for (const std::uint32_t c : star_)
    enough_height_ = std::min(enough_height_, height_ratio(triangle(table_.facet(c / 3))));
  const std::size_t tries = std::min(neighbors_.size(), most_tries);
  std::partial_sort(neighbors_.begin(), neighbors_.begin() + static_cast<std::ptrdiff_t>(tries),
                    neighbors_.end());
  for (std::size_t i = 0; i < tries; ++i)
    if (fits(v, neighbors_[i], allowed)) return commit(v, neighbors_[i], reached);
}

bool Thinner::link_condition(std::uint32_t v, std::uint32_t into) {
  ++now_;
  for (const std::uint32_t w : ring_) seen_[w] = now_;
  table_.star(into, others_);
  if (others_.size() + ring_.size() > most_neighbors + 4) return false;
  std::size_t common = 0;
  for (const std::uint32_t c : others_) {
    const std::uint32_t w = table_.vertex(CornerTable::next(c));
    if (w == v || seen_[w] != now_) continue;
    ++common;
    table_.star(w, of_common_);
    if (of_common_.size() == 3) return false;
  }
  return common == 2;
}

bool Thinner::fits(std::uint32_t v, const Neighbor& into, DirectionSet allowed) {
  const std::uint32_t stays = table_.vertex(CornerTable::next(into.corner));
  for (const std::uint32_t c : star_) {
    auto corners = table_.facet(c / 3);
    if (std::find(corners.begin(), corners.end(), stays) != corners.end()) continue;
    corners[c % 3] = stays;
    const Triangle3 t = triangle(corners);
    allowed &= directions_of(t);
    if (allowed == 0 || height_ratio(t) < enough_height_) return false;
  }
  return link_condition(v, stays);
}

void Thinner::commit(std::uint32_t v, const Neighbor& into, double distance) {
  const std::uint32_t stays = table_.vertex(CornerTable::next(into.corner));
  SurfaceChange change;
  std::vector<std::uint32_t> facets;
  for (const std::uint32_t c : star_) facets.push_back(c / 3);
  std::sort(facets.begin(), facets.end());
  for (const std::uint32_t f : facets) change.removed.push_back({f, table_.facet(f)});
  table_.collapse(into.corner);
  for (const std::uint32_t f : facets) {
    if (!table_.alive(f)) continue;
    change.added.push_back({f, table_.facet(f)});
    cells_.restrict(triangle(table_.facet(f)));
  }
  change.killed_vertices = {v};
  ImproverVerdict verdict;
  verdict.a = stays;
  verdict.b = v;
  verdict.target = points_[stays];
  verdict.value = verdict.cost = distance;
  verdict.limit = ground_.delta;
  verdict.placed = Reason::halfedge;
  result_.stopped = !observer_.accepted(change, verdict);
}

ThinnedMesh Thinner::compacted() {
  std::vector<std::uint32_t> ids(points_.size(), CornerTable::none);
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    if (!table_.has_facets(v)) continue;
    ids[v] = static_cast<std::uint32_t>(result_.vertices.size());
    result_.vertices.push_back(v);
    result_.mesh.points.push_back(points_[v]);
  }
  for (std::uint32_t f = 0; f < table_.facets(); ++f) {
    if (!table_.alive(f)) continue;
    const auto v = table_.facet(f);
    result_.facets.push_back(f);
    result_.mesh.triangles.push_back({ids[v[0]], ids[v[1]], ids[v[2]]});
  }
  return std::move(result_);
}

} // namespace

ThinnedMesh thin(const TriangleMesh& mesh, const ThinningGround& ground, const RunControl& control,
                 ImproverObserver& observer) {
  return Thinner(mesh, ground, control, observer).run();
}

} // namespace isoscope
