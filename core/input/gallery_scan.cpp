// A surface as a scanner sees it from one place: what lies behind bumps or is seen at too flat an angle is
// missing.
#include "input/gallery_shapes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace isoscope {
namespace {

struct Bump {
  Vec3 direction; ///< about of length one
  double height;
};
/// What is scanned: a ball with knobs, of which those that stand towards the scanner throw shadows.
constexpr double ball_radius = 0.8;
constexpr std::array<Bump, 3> bumps{
    {{{0.38, 0.12, 0.8}, 0.5}, {{-0.29, 0.27, 0.8}, 0.47}, {{-0.09, -0.39, 0.8}, 0.44}}};
/// Where the scanner is, and how wide a square it sees.
constexpr Vec3 scanner{0, 0, 1};
constexpr double half_width = 1.5, from = 2, to = -1.6, step = 0.01;
/// The cosine of the flattest angle that it sees, and how much farther than its neighbour a place may be, in
/// units of what lies between rays.
constexpr double flattest = 0.2, farthest_jump = 5;

double outside_of_model(Vec3 p) {
  const double r = length(p);
  double surface = ball_radius;
  for (const Bump& b : bumps) {
    double near = 0.5 * (1 + dot(p, b.direction) / (r * length(b.direction)));
    for (int i = 0; i < 6; ++i) near *= near; // a power, as the same bits are to come out everywhere
    surface += b.height * near;
  }
  return r - surface;
}

Vec3 normal_of_model(Vec3 p) {
  constexpr double h = 1e-5;
  Vec3 n;
  for (int a = 0; a < 3; ++a) {
    Vec3 forward = p, back = p;
    forward[a] += h;
    back[a] -= h;
    n[a] = outside_of_model(forward) - outside_of_model(back);
  }
  return normalized(n);
}

/// The first place along a ray towards -direction, as a distance along the direction; nothing where it
/// misses.
bool hit(Vec3 origin, Vec3 direction, double& at) {
  for (at = from; at > to; at -= step) {
    if (outside_of_model(origin + at * direction) >= 0) continue;
    double low = at, high = at + step;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (outside_of_model(origin + middle * direction) < 0 ? low : high) = middle;
    }
    at = low;
    return true;
  }
  return false;
}

} // namespace

TriangleSoup make_range_scan(int rays) {
  using Index = std::uint32_t;
  constexpr Index none = 0xffffffffu;
  const Vec3 w = normalized(scanner), u = normalized(cross({0, 1, 0}, w)), v = cross(w, u);
  const double between = 2 * half_width / (rays - 1);
  const auto n = static_cast<std::size_t>(rays);
  std::vector<Vec3> place(n * n);
  std::vector<double> depth(n * n);
  std::vector<bool> seen(n * n, false);
  for (std::size_t i = 0; i < n * n; ++i) {
    const Vec3 origin = (static_cast<double>(i % n) * between - half_width) * u +
                        (static_cast<double>(i / n) * between - half_width) * v;
    if (!hit(origin, w, depth[i])) continue;
    place[i] = origin + depth[i] * w;
    seen[i] = dot(normal_of_model(place[i]), w) > flattest;
  }
  TriangleSoup model;
  std::vector<Index> number(n * n, none);
  const auto add = [&](std::array<std::size_t, 3> t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!seen[t[k]] || std::abs(depth[t[k]] - depth[t[(k + 1) % 3]]) > farthest_jump * between) return;
    }
    std::array<Index, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      Index& at = number[t[k]];
      if (at == none) {
        at = static_cast<Index>(model.points.size());
        model.points.push_back(place[t[k]]);
      }
      corners[k] = at;
    }
    model.triangles.push_back(corners);
  };
  for (std::size_t y = 0; y + 1 < n; ++y)
    for (std::size_t x = 0; x + 1 < n; ++x) {
      const std::size_t a = y * n + x, b = a + 1, c = a + n + 1, d = a + n;
      add({a, b, c});
      add({a, c, d});
    }
  return model;
}

} // namespace isoscope
