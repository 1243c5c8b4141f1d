// Searches of the bounding volume hierarchy.
#include "tolerance/closest_point.h"

#include "tolerance/box_search.h"
#include "tolerance/bvh_builder.h"
#include "tolerance/index_building.h"
#include "tolerance/triangle_point.h"

#include <algorithm>

namespace isoscope {
namespace {

/// The normal of a triangle with a sharper angle loses too many digits.
constexpr double least_squared_sine = 1e-4;
/// What the computed height over a plane may be off by, relative to the largest coordinate: `fill` keeps
/// planes whose normal is exact to less than a tenth of this.
constexpr double plane_rounding = 1e-12;

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
  fill(
      soup.triangles.size(), [&](std::size_t i) { return soup.triangle(i); }, nullptr);
}

ClosestPointIndex::ClosestPointIndex(const TriangleSoup& soup, const RunControl& control) {
  fill(
      soup.triangles.size(), [&](std::size_t i) { return soup.triangle(i); }, &control);
}

ClosestPointIndex::ClosestPointIndex(std::span<const Triangle3> triangles, const RunControl& control) {
  fill(
      triangles.size(), [&](std::size_t i) -> const Triangle3& { return triangles[i]; }, &control);
}

template <class TriangleAt>
void ClosestPointIndex::fill(std::size_t count, const TriangleAt& given, const RunControl* control) {
  std::vector<Box3> boxes(count);
  for (std::size_t i = 0; i < count; ++i)
    for (const Vec3 p : given(i)) boxes[i].add(p);
  if (!BvhBuilder(boxes_, std::move(boxes), control).build()) {
    boxes_ = {};
    BvhBuilder(boxes_, {}).build();
    return;
  }
  for (std::size_t i = 0; i < count; ++i) area_ += isoscope::area(given(i));
  slots_.resize(count);
  triangles_.reserve(count);
  planes_.reserve(count);
  for (std::size_t slot = 0; slot < count; ++slot) {
    slots_[boxes_.ids[slot]] = static_cast<std::uint32_t>(slot);
    const Triangle3 t = given(boxes_.ids[slot]);
    triangles_.push_back(t);
    const Vec3 u = t[1] - t[0], v = t[2] - t[0], area = cross(u, v);
    const bool has_plane = squared_length(area) > least_squared_sine * squared_length(u) * squared_length(v);
    const Vec3 normal = has_plane ? normalized(area) : Vec3{};
    planes_.push_back({normal, dot(normal, t[0])});
  }
  if (count == 0) return;
  for (int a = 0; a < 3; ++a)
    largest_coordinate_ = std::max({largest_coordinate_, std::abs(bounds().lo[a]), std::abs(bounds().hi[a])});
}

std::shared_ptr<const ClosestPointIndex> build_index(const TriangleSoup& soup, const RunControl& control) {
  return std::make_shared<const ClosestPointIndex>(soup, control);
}

template <class Replaces>
ClosestPoint ClosestPointIndex::search(Vec3 p, ClosestPoint best, double squared_enough,
                                       const Replaces& replaces) const {
  const double plane_slack =
      plane_rounding * (largest_coordinate_ + std::abs(p.x) + std::abs(p.y) + std::abs(p.z));
  return search_boxes(
      boxes_, p, best, squared_enough, [](std::uint32_t) { return Lanes{}; },
      [&](std::uint32_t first, std::uint32_t count, ClosestPoint& found) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          const double height = std::abs(dot(planes_[slot].normal, p) - planes_[slot].offset) - plane_slack;
          if (height > 0 && height * height > found.squared_distance) continue;
          const Vec3 c = closest_point_inlined(p, triangles_[slot]);
          const double d2 = squared_length(c - p);
          if (replaces(d2, slot, found)) found = {c, d2, TriangleId(boxes_.ids[slot])};
        }
      });
}

ClosestPoint ClosestPointIndex::search(Vec3 p, ClosestPoint best, double squared_enough) const {
  return search(p, best, squared_enough, [](double d2, std::uint32_t, const ClosestPoint& found) {
    return d2 < found.squared_distance || (d2 == found.squared_distance && !found.triangle.valid());
  });
}

ClosestPoint ClosestPointIndex::nearest_from(Vec3 p, const ClosestPoint& found_before) const {
  return search(p, found_before, 0, [&](double d2, std::uint32_t slot, const ClosestPoint& found) {
    if (d2 != found.squared_distance) return d2 < found.squared_distance;
    return !found.triangle.valid() || id_at(slot) < found.triangle;
  });
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
  const double r2 = radius * radius;
  bool few = true;
  visit_within(
      boxes_, center, r2, [](std::uint32_t) { return Lanes{}; },
      [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          const Vec3 away = center - closest_point_inlined(center, triangles_[slot]);
          if (squared_length(away) <= r2) near.entries.push_back({length(away), normalized(away), slot});
        }
        return few = near.entries.size() <= most_neighbors;
      });
  if (!few) return;
  sort_neighbors(near.entries);
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
    const Vec3 c = closest_point_inlined(p, triangles_[e.slot]);
    const double d2 = squared_length(c - p);
    if (!(d2 < best.squared_distance)) continue;
    best = {c, d2, TriangleId(boxes_.ids[e.slot])};
    best_distance = std::sqrt(d2);
    if (best_distance < enough) return best;
  }
  if (best_distance + offset <= near.radius) return best;
  return best.triangle.valid() ? search(p, best) : closest_near(p, guess);
}

bool ClosestPointIndex::coplanar_within(Vec3 center, double radius, TriangleId site, double slack) const {
  const Plane plane = planes_[slot_of(site)];
  if (plane.normal == Vec3{}) return false;
  const double r2 = radius * radius;
  bool coplanar = true;
  visit_within(
      boxes_, center, r2, [](std::uint32_t) { return Lanes{}; },
      [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; coplanar && slot < first + count; ++slot) {
          const Triangle3& t = triangles_[slot];
          coplanar =
              std::all_of(t.begin(), t.end(),
                          [&](Vec3 p) { return std::abs(dot(plane.normal, p) - plane.offset) <= slack; }) ||
              squared_length(closest_point_on_triangle(center, t) - center) > r2;
        }
        return coplanar;
      });
  return coplanar;
}

template <class MeetsBox, class AtSlot>
void ClosestPointIndex::visit(const MeetsBox& meets_box, const AtSlot& at_slot) const {
  constexpr unsigned width = BoxHierarchy::width;
  const double scale = 1 / boxes_.inverse_scale;
  std::uint32_t stack[box_stack_size];
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const BoxHierarchy::Node& n = boxes_.nodes[stack[--top]];
    for (unsigned k = 0; k < width; ++k) {
      if (n.count[k] == BoxHierarchy::empty_child) continue;
      Box3 box;
      for (int a = 0; a < 3; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        box.lo[a] = boxes_.origin[a] + scale * (static_cast<double>(n.lo[axis][k]) - 1e-12);
        box.hi[a] = boxes_.origin[a] + scale * (static_cast<double>(n.hi[axis][k]) + 1e-12);
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
  constexpr std::size_t majority = parity_rays.size() / 2 + 1;
  std::array<std::size_t, 2> votes{};
  for (const Vec3 d : parity_rays) {
    const Vec3 inverse{1 / d.x, 1 / d.y, 1 / d.z};
    unsigned hits = 0;
    visit([&](const Box3& box) { return ray_meets(p, inverse, std::numeric_limits<double>::max(), box); },
          [&](std::uint32_t slot) { hits += crossing(p, d, triangles_[slot]) > 0 ? 1u : 0u; });
    if (++votes[hits & 1u] == majority) break;
  }
  return votes[1] >= majority;
}

int ClosestPointIndex::winding_number(Vec3 p, std::span<const std::int8_t> turns) const {
  std::array<int, parity_rays.size()> sums{};
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const Vec3 d = parity_rays[k], inverse{1 / d.x, 1 / d.y, 1 / d.z};
    visit([&](const Box3& box) { return ray_meets(p, inverse, std::numeric_limits<double>::max(), box); },
          [&](std::uint32_t slot) {
            const Triangle3& t = triangles_[slot];
            if (!(crossing(p, d, t) > 0)) return;
            const int turn = turns.empty() ? 1 : turns[boxes_.ids[slot]];
            sums[k] += dot(d, cross(t[1] - t[0], t[2] - t[0])) > 0 ? turn : -turn;
          });
    // What most rays say is the median.
    const auto same = std::count(sums.begin(), sums.begin() + k + 1, sums[k]);
    if (2 * static_cast<std::size_t>(same) > sums.size()) return sums[k];
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

std::vector<std::uint32_t> ClosestPointIndex::slots_within(const Box3& box, double reach) const {
  std::vector<std::uint32_t> found;
  visit(
      [&](const Box3& other) {
        double squared = 0;
        for (int a = 0; a < 3; ++a) {
          const double gap = std::max({0.0, other.lo[a] - box.hi[a], box.lo[a] - other.hi[a]});
          squared += gap * gap;
        }
        return squared <= reach * reach;
      },
      [&](std::uint32_t slot) { found.push_back(slot); });
  return found;
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
    if (meet(own)) found.push_back(TriangleId(boxes_.ids[slot]));
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
         slots_.capacity() * sizeof(std::uint32_t) + boxes_.memory_bytes();
}

} // namespace isoscope
