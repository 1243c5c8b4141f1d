// Searches over weighted points, and which of their balls hang together.
#include "tolerance/weighted_points.h"

#include "tolerance/box_search.h"
#include "tolerance/bvh_builder.h"

#include <algorithm>
#include <array>
#include <utility>

namespace isoscope {
namespace {

constexpr std::uint32_t sites_between_questions = 1024;
constexpr int most_steps = 12; ///< of a projection
/// How far from r a projected point may be, relative to r.
constexpr double projection_error = 1e-11;
/// A flatter gradient leads nowhere.
constexpr double least_slope = 1e-6;
/// What a sum of two squared distances may be off by, relatively.
constexpr double rounding = 1e-9;

} // namespace

WeightedPointIndex::WeightedPointIndex(const std::vector<WeightedPoint>& points, double area,
                                       const RunControl& control)
    : area_(area) {
  std::vector<Box3> boxes(points.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i].add(points[i].center);
  if (!BvhBuilder(boxes_, std::move(boxes), &control, BvhBuilder::large_leaf).build()) {
    boxes_ = {};
    BvhBuilder(boxes_, {}).build();
  }
  sites_.reserve(boxes_.ids.size());
  slots_.resize(boxes_.ids.size());
  for (std::size_t slot = 0; slot < boxes_.ids.size(); ++slot) {
    sites_.push_back(points[boxes_.ids[slot]]);
    slots_[boxes_.ids[slot]] = static_cast<std::uint32_t>(slot);
    weighted_ = weighted_ || sites_.back().weight > 0;
  }
  find_least_weights();
}

void WeightedPointIndex::find_least_weights() {
  constexpr double rounding = 1 - 2 * static_cast<double>(std::numeric_limits<float>::epsilon());
  const double to_frame = boxes_.inverse_scale * boxes_.inverse_scale * rounding;
  weights_.resize(boxes_.nodes.size());
  for (std::size_t node = boxes_.nodes.size(); node-- > 0;) {
    const BoxHierarchy::Node& n = boxes_.nodes[node];
    for (unsigned k = 0; k < BoxHierarchy::width; ++k) {
      float& least = weights_[node].of[k];
      least = 0;
      if (n.count[k] == BoxHierarchy::empty_child) continue;
      if (n.count[k] == 0) {
        const auto& below = weights_[n.child[k]].of;
        const auto& child = boxes_.nodes[n.child[k]];
        least = std::numeric_limits<float>::max();
        for (unsigned j = 0; j < BoxHierarchy::width; ++j)
          if (child.count[j] != BoxHierarchy::empty_child) least = std::min(least, below[j]);
        continue;
      }
      double w = sites_[n.child[k]].weight;
      for (std::uint32_t slot = n.child[k]; slot < n.child[k] + n.count[k]; ++slot)
        w = std::min(w, sites_[slot].weight);
      least = static_cast<float>(std::min(w * to_frame, 1e37));
    }
  }
}

ClosestPoint WeightedPointIndex::at_site(Vec3 p, TriangleId id) const {
  const WeightedPoint& s = site(id);
  const Vec3 away = p - s.center;
  const double flat = length(away), squared = squared_at(p, s);
  if (s.weight == 0) return {s.center, squared, id};
  return {flat > 0 ? p - (std::sqrt(squared) / flat) * away : p, squared, id};
}

ClosestPoint WeightedPointIndex::search(Vec3 p, ClosestPoint best, double squared_enough) const {
  const TriangleId before = best.triangle;
  best = search_boxes(
      boxes_, p, best, squared_enough, [&](std::uint32_t node) { return lanes(weights_[node].of); },
      [&](std::uint32_t first, std::uint32_t count, ClosestPoint& found) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          const double squared = squared_at(p, sites_[slot]);
          if (squared >= found.squared_distance) continue;
          found.squared_distance = squared;
          found.triangle = TriangleId(boxes_.ids[slot]);
        }
      });
  return best.triangle == before ? best : at_site(p, best.triangle);
}

ClosestPoint WeightedPointIndex::closest(Vec3 p) const {
  return search(p, {});
}

ClosestPoint WeightedPointIndex::closest_within(Vec3 p, double radius) const {
  ClosestPoint none;
  none.squared_distance = radius * radius;
  const ClosestPoint found = search(p, none);
  return found.triangle.valid() ? found : ClosestPoint();
}

ClosestPoint WeightedPointIndex::closest_near(Vec3 p, TriangleId guess) const {
  return guess.valid() ? search(p, at_site(p, guess)) : closest(p);
}

ClosestPoint WeightedPointIndex::closest_near(Vec3 p, const ClosestPoint& found, double enough) const {
  return search(p, found, enough * enough);
}

double WeightedPointIndex::convex_bound(const Triangle3& facet, TriangleId id) const {
  double squared = 0;
  for (const Vec3 p : facet) squared = std::max(squared, squared_at(p, site(id)));
  return std::sqrt(squared);
}

Vec3 WeightedPointIndex::gradient(Vec3 p, const ClosestPoint& at) const {
  const double d = at.distance();
  return d > 0 && at.triangle.valid() ? (p - site(at.triangle).center) / d : Vec3{};
}

std::optional<Vec3> WeightedPointIndex::project(Vec3 p, const ClosestPoint& at, double r) const {
  Vec3 q = p;
  ClosestPoint here = at;
  for (int step = 0; step < most_steps; ++step) {
    if (std::abs(here.distance() - r) <= projection_error * r) return q;
    // Onto the ball of the site; another one may reach farther there.
    const WeightedPoint& s = site(here.triangle);
    const Vec3 away = q - s.center;
    const double flat = length(away), squared = r * r - s.weight;
    if (!(squared > 0) || !(flat > least_slope * r)) return std::nullopt;
    q = s.center + (std::sqrt(squared) / flat) * away;
    here = closest_near(q, here.triangle);
  }
  return std::nullopt;
}

bool WeightedPointIndex::rises(Vec3 p, const ClosestPoint& at_p, Vec3 q, const ClosestPoint& at_q) const {
  const double step2 = squared_length(q - p);
  // Less the square of the way gone, φ² is concave along it: at least what its ends say.
  if (at_q.squared_distance >= (at_p.squared_distance + step2) * (1 - rounding)) return true;
  // A site that gives φ at both ends gives it between them.
  return at_p.triangle.valid() && at_p.triangle == at_q.triangle &&
         dot(p - site(at_p.triangle).center, q - p) >= 0;
}

void WeightedPointIndex::find_neighborhood(Vec3 center, double radius, TriangleNeighborhood& near) const {
  near.center = center;
  near.radius = 0;
  near.entries.clear();
  const double r2 = radius * radius;
  // Mostly there are too many: what makes an entry comes once they are known to be few.
  std::array<std::pair<double, std::uint32_t>, most_neighbors> found;
  std::size_t count = 0;
  bool few = true;
  visit_within(
      boxes_, center, r2, [&](std::uint32_t node) { return lanes(weights_[node].of); },
      [&](std::uint32_t first, std::uint32_t slots) {
        for (std::uint32_t slot = first; slot < first + slots; ++slot) {
          const double squared = squared_at(center, sites_[slot]);
          if (squared > r2) continue;
          if (count == found.size()) return few = false;
          found[count++] = {squared, slot};
        }
        return true;
      });
  if (!few) return;
  for (std::size_t i = 0; i < count; ++i) {
    const double d = std::sqrt(found[i].first);
    const std::uint32_t slot = found[i].second;
    // The part of the direction in R⁴ that steps in space have to do with.
    near.entries.push_back({d, d > 0 ? (center - sites_[slot].center) / d : Vec3{}, slot});
  }
  sort_neighbors(near.entries);
  near.radius = radius;
}

ClosestPoint WeightedPointIndex::closest_near(Vec3 p, TriangleId guess, const TriangleNeighborhood& near,
                                              double enough) const {
  const Vec3 step = p - near.center;
  const double offset = length(step);
  if (offset > near.radius) return closest_near(p, guess);
  double best = std::numeric_limits<double>::infinity(), best_distance = best;
  TriangleId best_site;
  for (const TriangleNeighborhood::Entry& e : near.entries) {
    if (e.distance - offset > best_distance) break;
    if (e.distance + dot(e.direction, step) > best_distance) continue;
    const double squared = squared_at(p, sites_[e.slot]);
    if (!(squared < best)) continue;
    best = squared;
    best_distance = std::sqrt(squared);
    best_site = TriangleId(boxes_.ids[e.slot]);
    if (best_distance < enough) return at_site(p, best_site);
  }
  if (!best_site.valid()) return closest_near(p, guess);
  const ClosestPoint found = at_site(p, best_site);
  return best_distance + offset <= near.radius ? found : search(p, found);
}

/// Finds the balls of one component after the other. Those that were found are out of the way of later
/// searches, so that each is looked at a few times only, however many meet.
class WeightedPointIndex::Flood {
 public:
  Flood(const WeightedPointIndex& index, double r)
      : index_(index), boxes_(index.boxes_), squared_(r * r), above_(boxes_.nodes.size(), root),
        left_(boxes_.nodes.size()), leaf_(index.size()) {
    constexpr unsigned width = BoxHierarchy::width;
    for (std::size_t node = boxes_.nodes.size(); node-- > 0;) {
      const BoxHierarchy::Node& n = boxes_.nodes[node];
      for (unsigned k = 0; k < width; ++k) {
        if (n.count[k] == BoxHierarchy::empty_child) continue;
        const auto here = static_cast<std::uint32_t>(width * node + k);
        if (n.count[k] == 0) {
          above_[n.child[k]] = here;
          for (const std::uint32_t sites : left_[n.child[k]]) left_[node][k] += sites;
          continue;
        }
        for (std::uint32_t slot = n.child[k]; slot < n.child[k] + n.count[k]; ++slot) {
          leaf_[slot] = here;
          if (has_ball(slot)) ++left_[node][k];
        }
      }
    }
    found_.resize(index.size());
  }

  bool has_ball(std::uint32_t slot) const { return index_.sites_[slot].weight < squared_; }
  bool found(std::uint32_t slot) const { return found_[slot]; }

  /// Calls at(slot) for all balls that hang together with this one; false once the control is cancelled.
  template <class At> bool flood(std::uint32_t start, const At& at, SparsePoll& poll) {
    take(start);
    while (!waiting_.empty()) {
      if (poll.cancelled()) return false;
      const std::uint32_t slot = waiting_.back();
      waiting_.pop_back();
      at(slot);
      take_meeting(slot);
    }
    return true;
  }

 private:
  static constexpr std::uint32_t root = 0xffffffffu;

  double radius(double weight) const { return std::sqrt(std::max(0.0, squared_ - weight)); }

  void take(std::uint32_t slot) {
    found_[slot] = true;
    waiting_.push_back(slot);
    for (std::uint32_t at = leaf_[slot]; at != root; at = above_[at / BoxHierarchy::width])
      --left_[at / BoxHierarchy::width][at % BoxHierarchy::width];
  }

  void take_meeting(std::uint32_t slot) {
    const WeightedPoint& ball = index_.sites_[slot];
    const double own = radius(ball.weight), margin = ChildDistances::margin(boxes_, ball.center);
    const double from_frame = 1 / (boxes_.inverse_scale * boxes_.inverse_scale);
    visit_boxes(
        boxes_, ball.center,
        [&](std::uint32_t node, unsigned k, double squared) {
          if (left_[node][k] == 0) return false;
          const double reach =
              own + radius(static_cast<double>(index_.weights_[node].of[k]) * from_frame) + margin;
          return squared <= reach * reach;
        },
        [&](std::uint32_t first, std::uint32_t count) {
          for (std::uint32_t other = first; other < first + count; ++other) {
            if (found_[other] || !has_ball(other)) continue;
            const WeightedPoint& s = index_.sites_[other];
            const double reach = own + radius(s.weight);
            if (squared_length(s.center - ball.center) <= reach * reach) take(other);
          }
          return true;
        });
  }

  const WeightedPointIndex& index_;
  const BoxHierarchy& boxes_;
  double squared_;
  std::vector<std::uint32_t> above_; ///< by node: the place of its child entry
  std::vector<std::array<std::uint32_t, BoxHierarchy::width>> left_; ///< balls below a child, not yet found
  std::vector<std::uint32_t> leaf_;                                  ///< by slot: the place of its leaf
  std::vector<bool> found_;
  std::vector<std::uint32_t> waiting_;
};

VolumeComponents WeightedPointIndex::components(double r, const RunControl& control) const {
  VolumeComponents result;
  result.of_triangle.assign(size(), VolumeComponents::none);
  Flood flood(*this, r);
  SparsePoll poll(control, sites_between_questions);
  for (std::size_t id = 0; id < size(); ++id) {
    const std::uint32_t start = slots_[id];
    if (flood.found(start) || !flood.has_ball(start)) continue;
    const auto number = static_cast<std::uint32_t>(result.count++);
    const auto at = [&](std::uint32_t slot) { result.of_triangle[boxes_.ids[slot]] = number; };
    if (!flood.flood(start, at, poll)) break;
  }
  return result;
}

std::size_t WeightedPointIndex::memory_bytes() const {
  return boxes_.memory_bytes() + sites_.capacity() * sizeof(WeightedPoint) +
         slots_.capacity() * sizeof(std::uint32_t) + weights_.capacity() * sizeof(LeastWeights);
}

} // namespace isoscope
