// Grows plane regions over edges, and cuts convex polygons out of them along their borders.
#include "tolerance/flat_parts.h"

#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace isoscope {
namespace {

/// Of the largest extent: how far the triangles of a region may leave its plane, and those of a part its
/// sides. Files of six digits are that rough.
constexpr double flatness = 1e-5;
/// Of the largest coordinate: more than what a few operations round off.
constexpr double foot_rounding = 1e-11;
/// Directions of the sides of parts: those of the longest edges of the region's border, and even ones.
constexpr std::size_t most_border_directions = 16, even_directions = 8;
/// Parts of a region, and triangles from which none could be made.
constexpr int most_parts = 64, most_failures = 128;

struct Point2 {
  double x = 0, y = 0;
};
double along(Point2 direction, Point2 p) {
  return direction.x * p.x + direction.y * p.y;
}

using Triangle2 = std::array<Point2, 3>;
using Segment2 = std::array<Point2, 2>;

double least_along(Point2 direction, const Segment2& s) {
  return std::min(along(direction, s[0]), along(direction, s[1]));
}
double most_along(Point2 direction, const Triangle2& t) {
  return std::max({along(direction, t[0]), along(direction, t[1]), along(direction, t[2])});
}

constexpr std::uint32_t nothing = 0xffffffffu;

/// By triangle, those across its edges where there is one only, else nothing.
std::vector<std::array<std::uint32_t, 3>> neighbours(const std::vector<IndexTriangle>& triangles) {
  std::vector<std::array<std::uint32_t, 3>> result(triangles.size(), {nothing, nothing, nothing});
  const std::vector<EdgeUse> uses = sorted_edge_uses(triangles);
  const auto set = [&](const EdgeUse& use, std::uint32_t other) {
    for (std::size_t k = 0; k < 3; ++k)
      if (triangles[use.triangle][k] == use.from()) result[use.triangle][k] = other;
  };
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i + 1;
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    if (end - i == 2) set(uses[i], uses[i + 1].triangle), set(uses[i + 1], uses[i].triangle);
    i = end;
  }
  return result;
}

} // namespace

/// Triangles in one plane, and the edges along which they end.
struct FlatParts::Region {
  Frame frame;
  std::vector<std::uint32_t> ids;
  std::vector<Triangle2> triangles;
  std::vector<Segment2> border;   ///< what lies on its left is of the region
  std::vector<Point2> directions; ///< of unit length, outwards
};

bool FlatParts::may_be_in(const ClosestPointIndex& index) {
  constexpr std::size_t most_pairs = 4096, one_in = 4;
  if (index.size() <= most_pairs) return true;
  const double slack = flatness * index.bounds().longest_edge();
  const std::size_t stride = index.size() / most_pairs;
  std::size_t pairs = 0, flat = 0;
  for (std::size_t i = 0; i + 1 < index.size(); i += stride, ++pairs) {
    const Triangle3 &t = index.triangle_at(static_cast<std::uint32_t>(i)),
                    &next = index.triangle_at(static_cast<std::uint32_t>(i + 1));
    const Vec3 normal = normalized(area_vector(t));
    if (normal != Vec3{} && std::all_of(next.begin(), next.end(),
                                        [&](Vec3 p) { return std::abs(dot(normal, p - t[0])) <= slack; }))
      ++flat;
  }
  return flat * one_in > pairs;
}

FlatParts::FlatParts(const ClosestPointIndex& index, const RunControl& control) {
  if (index.empty()) return;
  const WeldedMesh mesh = weld(index);
  const auto across = neighbours(mesh.triangles);
  const double slack = flatness * index.bounds().longest_edge();
  double largest = 0;
  for (int a = 0; a < 3; ++a)
    largest = std::max({largest, std::abs(index.bounds().lo[a]), std::abs(index.bounds().hi[a])});
  tolerance_ = foot_rounding * (largest + index.bounds().longest_edge());
  roughness_ = slack + tolerance_ * 1e3; // of sides that meet at more than a thousandth of a radian
  of_triangle_.assign(index.size(), none);

  std::vector<double> areas(index.size());
  std::vector<std::uint32_t> order(index.size());
  std::iota(order.begin(), order.end(), 0u);
  for (std::uint32_t t = 0; t < areas.size(); ++t) {
    const Triangle3& c = index.triangle(TriangleId(t));
    areas[t] = length(cross(c[1] - c[0], c[2] - c[0]));
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return areas[a] != areas[b] ? areas[a] > areas[b] : a < b;
  });
  std::vector<std::uint8_t> taken(index.size(), 0);
  for (const std::uint32_t seed : order) {
    if (control.cancelled()) {
      of_triangle_.clear();
      return;
    }
    if (taken[seed] != 0) continue;
    const Triangle3& c = index.triangle(TriangleId(seed));
    const Vec3 normal = normalized(cross(c[1] - c[0], c[2] - c[0])), u = normalized(c[1] - c[0]);
    if (!(squared_length(normal) > 0)) break; // nothing but needles is left
    Region region{{c[0], u, cross(normal, u), normal}, {seed}, {}, {}, {}};
    taken[seed] = 1;
    const auto in_plane = [&](std::uint32_t t) {
      const Triangle3& other = index.triangle(TriangleId(t));
      return std::all_of(other.begin(), other.end(),
                         [&](Vec3 p) { return std::abs(dot(normal, p - c[0])) <= slack; });
    };
    for (std::size_t i = 0; i < region.ids.size(); ++i)
      for (const std::uint32_t t : across[region.ids[i]])
        if (t != nothing && taken[t] == 0 && in_plane(t)) taken[t] = 1, region.ids.push_back(t);
    if (region.ids.size() < 2) continue;
    std::sort(region.ids.begin(), region.ids.end(), [&](std::uint32_t a, std::uint32_t b) {
      return areas[a] != areas[b] ? areas[a] > areas[b] : a < b;
    });
    const auto flat = [&](Vec3 p) {
      return Point2{dot(region.frame.u, p - c[0]), dot(region.frame.v, p - c[0])};
    };
    // Each triangle counts once wherever it is seen from above: then the sum changes across the border alone.
    struct Use {
      std::uint32_t low, high;
      int turn;
    };
    std::vector<Use> uses;
    for (const std::uint32_t id : region.ids) {
      const Triangle3& t = index.triangle(TriangleId(id));
      region.triangles.push_back({flat(t[0]), flat(t[1]), flat(t[2])});
      const int turn = dot(normal, cross(t[1] - t[0], t[2] - t[0])) >= 0 ? 1 : -1;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = mesh.triangles[id][k], b = mesh.triangles[id][(k + 1) % 3];
        uses.push_back({std::min(a, b), std::max(a, b), a < b ? turn : -turn});
      }
    }
    std::sort(uses.begin(), uses.end(),
              [](const Use& a, const Use& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
    for (std::size_t i = 0; i < uses.size();) {
      int sum = 0;
      std::size_t end = i;
      for (; end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high; ++end)
        sum += uses[end].turn;
      Segment2 s{flat(mesh.points[uses[i].low]), flat(mesh.points[uses[i].high])};
      if (sum < 0) std::swap(s[0], s[1]);
      if (sum != 0) region.border.push_back(s);
      i = end;
    }
    divide(region, slack);
  }
}

void FlatParts::divide(const Region& given, double slack) {
  Region region = given;
  std::stable_sort(region.border.begin(), region.border.end(), [](const Segment2& a, const Segment2& b) {
    return std::hypot(a[1].x - a[0].x, a[1].y - a[0].y) > std::hypot(b[1].x - b[0].x, b[1].y - b[0].y);
  });
  const auto add = [&](Point2 d, double least_sine) {
    const auto same = [&](Point2 e) {
      return along(d, e) > 0 && std::abs(d.x * e.y - d.y * e.x) < least_sine;
    };
    if (std::none_of(region.directions.begin(), region.directions.end(), same))
      region.directions.push_back(d);
  };
  for (const Segment2& s : region.border) {
    if (region.directions.size() >= most_border_directions) break;
    const double dx = s[1].x - s[0].x, dy = s[1].y - s[0].y, l = std::hypot(dx, dy);
    if (l > 0) add({dy / l, -dx / l}, 1e-3);
  }
  for (std::size_t k = 0; k < even_directions; ++k) {
    const double angle = 2 * 3.14159265358979 * static_cast<double>(k) / even_directions;
    add({std::cos(angle), std::sin(angle)}, 0.1);
  }

  const auto holds = [&](const std::vector<double>& most, const Triangle2& t) {
    for (std::size_t k = 0; k < most.size(); ++k)
      if (most_along(region.directions[k], t) > most[k] + slack) return false;
    return true;
  };
  /// The sides of a polygon around a triangle that no border enters; empty where there is none.
  const auto grow = [&](const Triangle2& t) {
    const Point2 center{(t[0].x + t[1].x + t[2].x) / 3, (t[0].y + t[1].y + t[2].y) / 3};
    std::vector<std::pair<double, std::size_t>> nearest;
    for (std::size_t i = 0; i < region.border.size(); ++i) {
      const Segment2& s = region.border[i];
      const double dx = s[1].x - s[0].x, dy = s[1].y - s[0].y, l2 = dx * dx + dy * dy;
      const double at =
          l2 > 0 ? std::clamp(((center.x - s[0].x) * dx + (center.y - s[0].y) * dy) / l2, 0., 1.) : 0;
      nearest.emplace_back(std::hypot(s[0].x + at * dx - center.x, s[0].y + at * dy - center.y), i);
    }
    std::sort(nearest.begin(), nearest.end());
    std::vector<double> most(region.directions.size(), 1e300);
    for (const auto& [distance, i] : nearest) {
      const Segment2& s = region.border[i];
      double widest = -2 * slack;
      std::size_t best = most.size();
      bool outside = false;
      for (std::size_t k = 0; k < most.size() && !outside; ++k) {
        const double least = least_along(region.directions[k], s);
        outside = least >= most[k];
        const double gap = least - most_along(region.directions[k], t);
        if (gap > widest + slack) widest = gap, best = k; // among equals the border's own directions
      }
      if (outside) continue;
      if (best == most.size()) return std::vector<double>{};
      most[best] = least_along(region.directions[best], s);
    }
    for (std::size_t k = 0; k < most.size(); ++k)
      if (along(region.directions[k], center) >= most[k]) return std::vector<double>{};
    return most;
  };
  int made = 0, failures = 0;
  for (std::size_t i = 0; i < region.ids.size() && made < most_parts && failures < most_failures; ++i) {
    if (of_triangle_[region.ids[i]] != none) continue;
    const std::vector<double> most = grow(region.triangles[i]);
    std::vector<std::uint32_t> held;
    if (!most.empty())
      for (std::size_t j = i; j < region.ids.size(); ++j)
        if (of_triangle_[region.ids[j]] == none && holds(most, region.triangles[j]))
          held.push_back(region.ids[j]);
    if (held.size() < 2) {
      ++failures;
      continue;
    }
    ++made;
    for (const std::uint32_t t : held) of_triangle_[t] = static_cast<std::uint32_t>(parts_.size());
    const std::size_t first = halves_.size();
    for (std::size_t k = 0; k < most.size(); ++k)
      if (most[k] < 1e300) halves_.push_back({region.directions[k].x, region.directions[k].y, most[k]});
    parts_.push_back({region.frame, first, halves_.size()});
  }
}

std::optional<Vec3> FlatParts::away_from(std::uint32_t part, Vec3 p) const {
  const auto& [frame, first, last] = parts_[part];
  const Vec3 from = p - frame.origin;
  double x = dot(frame.u, from), y = dot(frame.v, from);
  // To the line that it is farthest beyond, from there to the corner with the next one.
  std::size_t before = last;
  for (int step = 0;; ++step) {
    double beyond = tolerance_;
    std::size_t worst = last;
    for (std::size_t k = first; k < last; ++k) {
      const double d = halves_[k].nx * x + halves_[k].ny * y - halves_[k].most;
      if (d > beyond) beyond = d, worst = k;
    }
    if (worst == last) break;
    if (step == 3) return std::nullopt;
    const Half& h = halves_[worst];
    double sine = 0;
    if (before != last) sine = halves_[before].nx * h.ny - halves_[before].ny * h.nx;
    if (std::abs(sine) < 1e-3) {
      x -= beyond * h.nx;
      y -= beyond * h.ny;
    } else {
      const Half& g = halves_[before];
      x = (g.most * h.ny - h.most * g.ny) / sine;
      y = (h.most * g.nx - g.most * h.nx) / sine;
    }
    before = worst;
  }
  return p - (frame.origin + x * frame.u + y * frame.v);
}

} // namespace isoscope
