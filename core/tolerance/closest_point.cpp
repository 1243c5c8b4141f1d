// Searches of the bounding volume hierarchy.
#include "tolerance/closest_point.h"

#include "tolerance/bvh_builder.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace isoscope {
namespace {

/// Nodes that wait on a search's stack: three a level, and levels are bounded by the builder.
constexpr std::size_t stack_size = 256;
/// Longer lists of neighbours would be slower than the hierarchy.
constexpr std::size_t most_neighbors = 128;
/// Relative rounding of a float operation, with room for the few that follow each other.
constexpr float float_slack = 4 * std::numeric_limits<float>::epsilon();

/// What the computed height over a plane may be off by, relative to the largest coordinate: the builder keeps
/// planes whose normal is exact to less than a tenth of this.
constexpr double plane_rounding = 1e-12;

/// Children that wait in a search, the one with the smallest bound on top of those pushed together. Entries
/// are single words: bounds are not negative, so that their bits have their order.
class WaitingChildren {
 public:
  bool empty() const { return top_ == 0; }
  /// Where the children of another node begin.
  void begin_node() { first_ = top_; }
  /// `bound`: of the squared distance, in the normalised frame.
  void push(float bound, std::uint32_t child, std::uint8_t count) {
    const std::uint64_t key = std::uint64_t{std::bit_cast<std::uint32_t>(bound)} << 32 | child;
    std::size_t at = top_++;
    for (; at > first_ && keys_[at - 1] < key; --at) keys_[at] = keys_[at - 1], counts_[at] = counts_[at - 1];
    keys_[at] = key;
    counts_[at] = count;
  }
  void pop() { --top_; }
  float bound() const { return std::bit_cast<float>(static_cast<std::uint32_t>(keys_[top_ - 1] >> 32)); }
  std::uint32_t child() const { return static_cast<std::uint32_t>(keys_[top_ - 1]); }
  std::uint32_t count() const { return counts_[top_ - 1]; }

 private:
  std::uint64_t keys_[stack_size];
  std::uint32_t counts_[stack_size];
  std::size_t top_ = 0, first_ = 0;
};

/// Four floats that the compiler keeps in one register: branches for each of them cost more than the sums.
using Lanes = float __attribute__((vector_size(16)));

Lanes lanes(const float (&values)[4]) {
  Lanes loaded;
  std::memcpy(&loaded, values, sizeof loaded);
  return loaded;
}

/// Directions that no axis-aligned or symmetric model lines up with.
constexpr std::array<Vec3, 5> parity_rays{{{.8123, .3331, .4781},
                                           {-.2717, .9011, .3379},
                                           {.1513, -.4297, .8902},
                                           {-.6113, -.5709, .5478},
                                           {.3301, .2203, -.9179}}};

/// The parameter t at which o + t d crosses the triangle, NaN when it does not.
double crossing(Vec3 o, Vec3 d, const Triangle3& t) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Vec3 e1 = t[1] - t[0], e2 = t[2] - t[0], p = cross(d, e2);
  const double det = dot(e1, p);
  if (det == 0) return none;
  const Vec3 s = o - t[0];
  const double u = dot(s, p) / det;
  if (!(u >= 0 && u <= 1)) return none;
  const Vec3 q = cross(s, e1);
  const double v = dot(d, q) / det;
  if (!(v >= 0 && u + v <= 1)) return none;
  return dot(e2, q) / det;
}

/// Whether o + t d, t in [0, t_end], meets the box grown by a rounding margin.
bool ray_meets(Vec3 o, Vec3 inverse_d, double t_end, const Box3& box) {
  double t0 = 0, t1 = t_end;
  for (int k = 0; k < 3; ++k) {
    const double a = (box.lo[k] - o[k]) * inverse_d[k], b = (box.hi[k] - o[k]) * inverse_d[k];
    if (std::isnan(a) || std::isnan(b)) continue; // parallel to the slab and on its face
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
  }
  return t0 <= t1 + 1e-9 * (1 + std::abs(t1));
}

} // namespace

ClosestPointIndex::ClosestPointIndex(const TriangleSoup& soup) {
  BvhBuilder(*this, soup).build();
}

ClosestPoint ClosestPointIndex::search(Vec3 p, ClosestPoint best, double squared_enough) const {
  // Lower bounds are computed in float in the frame of the input's box, with slack for every rounding, so
  // that no triangle is missed; distances to triangles are computed in double.
  float q[3], reach = 1;
  for (int a = 0; a < 3; ++a) {
    const double x = std::clamp((p[a] - origin_[a]) * inverse_scale_, -1e15, 1e15);
    q[a] = static_cast<float>(x);
    reach = std::max(reach, std::abs(q[a]));
  }
  const float slack = float_slack * reach;
  const float from_below[3] = {q[0] + slack, q[1] + slack, q[2] + slack};
  const float from_above[3] = {q[0] - slack, q[1] - slack, q[2] - slack};
  const double plane_slack =
      plane_rounding * (largest_coordinate_ + std::abs(p.x) + std::abs(p.y) + std::abs(p.z));
  const double to_frame = inverse_scale_ * inverse_scale_;
  const auto frame_bound = [&](double squared) {
    return static_cast<float>(std::min(squared * to_frame, 1e37)) * (1 + 2 * float_slack);
  };
  float limit = frame_bound(best.squared_distance);

  WaitingChildren waiting;
  waiting.push(0, 0, 0);
  while (!waiting.empty()) {
    const float next_bound = waiting.bound();
    const std::uint32_t child = waiting.child(), count = waiting.count();
    waiting.pop();
    if (next_bound > limit) continue;
    if (count > 0) {
      for (std::uint32_t slot = child; slot < child + count; ++slot) {
        const double height = std::abs(dot(planes_[slot].normal, p) - planes_[slot].offset) - plane_slack;
        if (height > 0 && height * height > best.squared_distance) continue;
        const Vec3 c = closest_point_on_triangle(p, triangles_[slot]);
        const double d2 = squared_length(c - p);
        if (d2 < best.squared_distance || (d2 == best.squared_distance && !best.triangle.valid()))
          best = {c, d2, TriangleId(ids_[slot])};
      }
      if (best.squared_distance < squared_enough) return best;
      limit = frame_bound(best.squared_distance);
      continue;
    }
    const Node& n = nodes_[child];
    Lanes bound{};
    for (unsigned a = 0; a < 3; ++a) {
      const Lanes below = lanes(n.lo[a]) - from_below[a], above = from_above[a] - lanes(n.hi[a]);
      Lanes d = below > 0 ? below : Lanes{};
      d = above > d ? above : d;
      bound += d * d;
    }
    waiting.begin_node();
    for (unsigned k = 0; k < width; ++k)
      if (bound[k] <= limit && n.count[k] != empty_child) waiting.push(bound[k], n.child[k], n.count[k]);
  }
  return best;
}

ClosestPoint ClosestPointIndex::closest_within(Vec3 p, double radius) const {
  ClosestPoint none;
  if (radius < std::numeric_limits<double>::infinity()) none.squared_distance = radius * radius;
  ClosestPoint found = search(p, none);
  if (!found.triangle.valid()) found.squared_distance = std::numeric_limits<double>::infinity();
  return found;
}

ClosestPoint ClosestPointIndex::closest_near(Vec3 p, TriangleId guess) const {
  if (!guess.valid()) return closest(p);
  const Vec3 c = closest_point_on_triangle(p, triangle(guess));
  return search(p, {c, squared_length(c - p), guess});
}

void ClosestPointIndex::find_neighborhood(Vec3 center, double radius, TriangleNeighborhood& near) const {
  near.center = center;
  near.radius = 0;
  near.entries.clear();
  const double r2 = radius * radius, scale = 1 / inverse_scale_;
  const double margin = 1e-12 * scale * std::max(1.0, length(center - origin_) * inverse_scale_);
  const double box_r2 = (radius + margin) * (radius + margin);
  std::uint32_t stack[stack_size];
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& n = nodes_[stack[--top]];
    double bound[width] = {};
    for (std::size_t a = 0; a < 3; ++a) {
      const double x = (center[static_cast<int>(a)] - origin_[static_cast<int>(a)]) * inverse_scale_;
      for (unsigned k = 0; k < width; ++k) {
        const double below = static_cast<double>(n.lo[a][k]) - x, above = x - static_cast<double>(n.hi[a][k]);
        const double d = std::max(0.0, std::max(below, above)) * scale;
        bound[k] += d * d;
      }
    }
    for (unsigned k = 0; k < width; ++k) {
      if (n.count[k] == empty_child || bound[k] > box_r2) continue;
      if (n.count[k] == 0) {
        stack[top++] = n.child[k];
        continue;
      }
      for (std::uint32_t slot = n.child[k]; slot < n.child[k] + n.count[k]; ++slot) {
        const Vec3 away = center - closest_point_on_triangle(center, triangles_[slot]);
        if (squared_length(away) <= r2) near.entries.push_back({length(away), normalized(away), slot});
      }
      if (near.entries.size() > most_neighbors) return;
    }
  }
  std::sort(near.entries.begin(), near.entries.end(), [](const auto& a, const auto& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.slot < b.slot;
  });
  near.radius = radius;
}

ClosestPoint ClosestPointIndex::closest_near(Vec3 p, TriangleId guess, const TriangleNeighborhood& near,
                                             double enough) const {
  const Vec3 step = p - near.center;
  const double offset = length(step);
  if (offset > near.radius) return closest_near(p, guess);
  ClosestPoint best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (const TriangleNeighborhood::Entry& e : near.entries) {
    if (e.distance - offset > best_distance) break;
    if (e.distance + dot(e.direction, step) > best_distance) continue;
    const Vec3 c = closest_point_on_triangle(p, triangles_[e.slot]);
    const double d2 = squared_length(c - p);
    if (!(d2 < best.squared_distance)) continue;
    best = {c, d2, TriangleId(ids_[e.slot])};
    best_distance = std::sqrt(d2);
    if (best_distance < enough) return best;
  }
  if (best_distance + offset <= near.radius) return best;
  return best.triangle.valid() ? search(p, best) : closest_near(p, guess);
}

template <class MeetsBox, class AtSlot>
void ClosestPointIndex::visit(const MeetsBox& meets_box, const AtSlot& at_slot) const {
  const double scale = 1 / inverse_scale_;
  std::uint32_t stack[stack_size];
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& n = nodes_[stack[--top]];
    for (unsigned k = 0; k < width; ++k) {
      if (n.count[k] == empty_child) continue;
      Box3 box;
      for (int a = 0; a < 3; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        box.lo[a] = origin_[a] + scale * (static_cast<double>(n.lo[axis][k]) - 1e-12);
        box.hi[a] = origin_[a] + scale * (static_cast<double>(n.hi[axis][k]) + 1e-12);
      }
      if (!meets_box(box)) continue;
      if (n.count[k] == 0) {
        stack[top++] = n.child[k];
      } else {
        for (std::uint32_t slot = n.child[k]; slot < n.child[k] + n.count[k]; ++slot) at_slot(slot);
      }
    }
  }
}

bool ClosestPointIndex::inside_by_parity(Vec3 p) const {
  unsigned votes = 0;
  for (const Vec3 d : parity_rays) {
    const Vec3 inverse{1 / d.x, 1 / d.y, 1 / d.z};
    unsigned hits = 0;
    visit([&](const Box3& box) { return ray_meets(p, inverse, std::numeric_limits<double>::max(), box); },
          [&](std::uint32_t slot) { hits += crossing(p, d, triangles_[slot]) > 0 ? 1u : 0u; });
    votes += hits & 1u;
  }
  return 2 * votes > parity_rays.size();
}

int ClosestPointIndex::winding_number(Vec3 p, std::span<const std::int8_t> turns) const {
  std::array<int, parity_rays.size()> sums{};
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const Vec3 d = parity_rays[k], inverse{1 / d.x, 1 / d.y, 1 / d.z};
    visit([&](const Box3& box) { return ray_meets(p, inverse, std::numeric_limits<double>::max(), box); },
          [&](std::uint32_t slot) {
            const Triangle3& t = triangles_[slot];
            if (!(crossing(p, d, t) > 0)) return;
            const int turn = turns.empty() ? 1 : turns[ids_[slot]];
            sums[k] += dot(d, cross(t[1] - t[0], t[2] - t[0])) > 0 ? turn : -turn;
          });
  }
  std::nth_element(sums.begin(), sums.begin() + sums.size() / 2, sums.end());
  return sums[sums.size() / 2];
}

std::vector<double> ClosestPointIndex::crossings(Vec3 a, Vec3 b) const {
  const Vec3 d = b - a;
  const Vec3 inverse{1 / d.x, 1 / d.y, 1 / d.z};
  std::vector<double> parameters;
  visit([&](const Box3& box) { return ray_meets(a, inverse, 1, box); },
        [&](std::uint32_t slot) {
          const double t = crossing(a, d, triangles_[slot]);
          if (t > 0 && t < 1) parameters.push_back(t);
        });
  std::sort(parameters.begin(), parameters.end());
  return parameters;
}

std::vector<TriangleId> ClosestPointIndex::triangles_in(const Box3& box) const {
  const auto meet = [&](const Box3& other) {
    for (int a = 0; a < 3; ++a)
      if (other.lo[a] > box.hi[a] || other.hi[a] < box.lo[a]) return false;
    return true;
  };
  std::vector<TriangleId> found;
  visit(meet, [&](std::uint32_t slot) {
    Box3 own;
    for (const Vec3 v : triangles_[slot]) own.add(v);
    if (meet(own)) found.push_back(TriangleId(ids_[slot]));
  });
  std::sort(found.begin(), found.end());
  return found;
}

double ClosestPointIndex::convex_bound(const Triangle3& facet, TriangleId site) const {
  const Triangle3& nearest = triangle(site);
  double bound2 = 0;
  for (const Vec3 p : facet)
    bound2 = std::max(bound2, squared_length(closest_point_on_triangle(p, nearest) - p));
  return std::sqrt(bound2);
}

std::size_t ClosestPointIndex::memory_bytes() const {
  return triangles_.capacity() * sizeof(Triangle3) + planes_.capacity() * sizeof(Plane) +
         (ids_.capacity() + slots_.capacity()) * sizeof(std::uint32_t) + nodes_.capacity() * sizeof(Node);
}

} // namespace isoscope
