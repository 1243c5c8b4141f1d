// What the clip leaves to be seen: points, whole cells, stretches of a ray.
#include "scene/clip.h"

#include <algorithm>
#include <cmath>

namespace isoscope {

using Shape = ClipSettings::Shape;
using Mode = ClipSettings::Mode;

double Clip::kept_distance(Vec3 p) const {
  const Vec3 offset = p - settings_.point;
  double kept = Box3::inf;
  switch (settings_.shape) {
  case Shape::none:
    return kept;
  case Shape::plane:
    kept = -dot(offset, settings_.normal);
    break;
  case Shape::slab:
    kept = settings_.radius - std::abs(dot(offset, settings_.normal));
    break;
  case Shape::ball:
    kept = settings_.radius - length(offset);
    break;
  }
  return settings_.flipped ? -kept : kept;
}

bool Clip::straddles(std::span<const Vec3> corners) const {
  // A slab has two surfaces, and a cell may pass through both.
  const auto crosses = [&](auto&& signed_distance) {
    double lo = Box3::inf, hi = -Box3::inf;
    for (const Vec3 p : corners) {
      lo = std::min(lo, signed_distance(p));
      hi = std::max(hi, signed_distance(p));
    }
    return lo <= 0 && hi >= 0;
  };
  if (settings_.shape != Shape::slab) return crosses([&](Vec3 p) { return kept_distance(p); });
  const auto height = [&](Vec3 p) { return dot(p - settings_.point, settings_.normal); };
  return crosses([&](Vec3 p) { return height(p) - settings_.radius; }) ||
         crosses([&](Vec3 p) { return height(p) + settings_.radius; });
}

bool Clip::shows_cell(std::span<const Vec3> corners) const {
  if (!active()) return true;
  if (settings_.mode == Mode::straddle) return straddles(corners);
  if (settings_.mode == Mode::whole_cells) {
    Vec3 sum;
    for (const Vec3 p : corners) sum += p;
    return keeps(sum / static_cast<double>(corners.size()));
  }
  return straddles(corners) || std::any_of(corners.begin(), corners.end(), [&](Vec3 p) { return keeps(p); });
}

bool Clip::shows_point(Vec3 p, std::span<const Vec3> cell) const {
  if (!active()) return true;
  if (settings_.mode == Mode::cut || cell.empty()) return keeps(p);
  return shows_cell(cell);
}

std::vector<std::array<double, 2>> Clip::kept_intervals(Vec3 origin, Vec3 direction, double lo,
                                                        double hi) const {
  if (lo >= hi) return {};
  if (!active()) return {{lo, hi}};
  // The unflipped region is convex: one stretch [a, b].
  double a = -Box3::inf, b = Box3::inf;
  const Vec3 offset = origin - settings_.point;
  const auto below = [&](Vec3 normal, double limit) { // normal·(offset + t direction) <= limit
    const double rate = dot(normal, direction), rest = limit - dot(normal, offset);
    if (rate > 0) b = std::min(b, rest / rate);
    if (rate < 0) a = std::max(a, rest / rate);
    if (rate == 0 && rest < 0) b = -Box3::inf;
  };
  switch (settings_.shape) {
  case Shape::none:
    break;
  case Shape::plane:
    below(settings_.normal, 0);
    break;
  case Shape::slab:
    below(settings_.normal, settings_.radius);
    below(-settings_.normal, settings_.radius);
    break;
  case Shape::ball: {
    const double dd = dot(direction, direction), od = dot(offset, direction);
    const double disc = od * od - dd * (dot(offset, offset) - settings_.radius * settings_.radius);
    if (disc < 0) {
      b = -Box3::inf;
    } else {
      a = (-od - std::sqrt(disc)) / dd;
      b = (-od + std::sqrt(disc)) / dd;
    }
    break;
  }
  }
  std::vector<std::array<double, 2>> kept;
  const auto add = [&](double from, double to) {
    from = std::max(from, lo);
    to = std::min(to, hi);
    if (from < to) kept.push_back({from, to});
  };
  if (!settings_.flipped) {
    add(a, b);
  } else if (a > b) {
    add(lo, hi);
  } else {
    add(lo, a);
    add(b, hi);
  }
  return kept;
}

} // namespace isoscope
