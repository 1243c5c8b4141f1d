// Balls that hold nothing of the input lead from a triangle to where it is deepest; their points are on its
// side.
#include "tiles/held_points.h"

#include "base/point_order.h"
#include "base/halves.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

/// In δ: places that are looked at stand for what is so near, and parts of triangles are no larger.
constexpr double stands_for = 0.25, largest_part = 0.15;
/// In δ: so much deeper is a point beyond δ.
constexpr double margin_of_depth = 1e-3;
/// The first ball is at most δ/2 and at least so many halvings of that in radius.
constexpr int most_halvings_of_ball = 24;
constexpr int most_steps_of_climb = 32;
/// Of a ball's radius: a step within it; and a shorter one, where long ones lead nowhere.
constexpr std::array<double, 2> steps_of_ball{0.95, 0.35};
constexpr double worthwhile_step = 1.01, good_step = 1.4; ///< new radius over old
constexpr double ball_slack = 1e-9;

std::array<Vec3, 26> directions() {
  std::array<Vec3, 26> all;
  std::size_t n = 0;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) all[n++] = normalized({double(x), double(y), double(z)});
  return all;
}

} // namespace

void HeldPoints::Places::add(Vec3 p) {
  grid_.add(p);
  points_.push_back(p);
}

bool HeldPoints::Places::any_within(Vec3 p, double radius) const {
  const auto is_near = [&](std::uint32_t i) { return distance(points_[i], p) <= radius; };
  // Neighbours mostly have the same one.
  if (last_ < points_.size() && is_near(last_)) return true;
  found_.clear();
  grid_.gather(Box3{p, p}.grown(radius), found_);
  const auto any = std::find_if(found_.begin(), found_.end(), is_near);
  if (any == found_.end()) return false;
  last_ = *any;
  return true;
}

HeldPoints::HeldPoints(Vec3 origin, double delta, double cover)
    : delta_(delta),
      near_(cover - (stands_for + largest_part) * delta), sides_{Side{-1, Places(origin, near_),
                                                                      Places(origin, stands_for * delta)},
                                                                 Side{+1, Places(origin, near_),
                                                                      Places(origin, stands_for * delta)}} {}

void HeldPoints::look(const ClosestPointIndex& piece, const std::function<bool(Vec3)>& wanted,
                      const RunControl& control) {
  SparsePoll poll(control, 64);
  for (Side& side : sides_) {
    std::vector<Bare> bare;
    for (std::size_t i = 0; i < piece.size() && !poll.cancelled(); ++i)
      look_at(piece, piece.triangle(TriangleId(i)), TriangleId(i), wanted, side, bare);
    // The deepest first: those keep Z from the least.
    std::sort(bare.begin(), bare.end(), [](const Bare& a, const Bare& b) {
      return a.depth != b.depth ? a.depth > b.depth : lies_before(a.place, b.place);
    });
    for (const Bare& b : bare) {
      if (!(b.depth > 0) || side.deep.any_within(b.place, near_)) continue;
      side.deep.add(b.deepest);
      held_.push_back(b.deepest);
    }
  }
}

void HeldPoints::look_at(const ClosestPointIndex& piece, const Triangle3& triangle, TriangleId id,
                         const std::function<bool(Vec3)>& wanted, Side& side, std::vector<Bare>& bare) const {
  const Vec3 normal = normalized(area_vector(triangle));
  if (normal == Vec3{}) return;
  std::vector<Triangle3> open{triangle};
  while (!open.empty()) {
    const Triangle3 t = open.back();
    open.pop_back();
    const Vec3 c = centroid(t);
    const double radius = std::max({distance(c, t[0]), distance(c, t[1]), distance(c, t[2])});
    if (radius < near_ && side.deep.any_within(c, near_ - radius)) continue;
    if (radius > largest_part * delta_) {
      for (const Triangle3& half : halves(t)) open.push_back(half);
      continue;
    }
    if (!wanted(c) || side.looked.any_within(c, stands_for * delta_)) continue;
    const Bare found = climb(piece, c, side.sign * normal, id);
    if (found.depth > (1 + margin_of_depth) * delta_) {
      side.deep.add(found.deepest);
    } else {
      side.looked.add(c);
      bare.push_back(found);
    }
  }
}

HeldPoints::Bare HeldPoints::climb(const ClosestPointIndex& piece, Vec3 place, Vec3 way,
                                   TriangleId id) const {
  static const std::array<Vec3, 26> around = directions();
  Bare at{place, place, 0};
  TriangleId near = id;
  const auto depth_at = [&](Vec3 p) {
    const ClosestPoint closest = piece.closest_near(p, near);
    near = closest.triangle;
    return closest.distance();
  };
  double radius = 0.5 * delta_;
  for (int i = 0; i < most_halvings_of_ball && !(at.depth > 0); ++i, radius *= 0.5) {
    const Vec3 p = place + radius * way;
    // The ball touches the input in the place alone.
    if (const double depth = depth_at(p); depth >= (1 - ball_slack) * radius) at = {place, p, depth};
  }
  for (int step = 0; step < most_steps_of_climb && at.depth > 0; ++step) {
    if (at.depth > (1 + margin_of_depth) * delta_) break;
    const Bare from = at;
    const auto try_step = [&](Vec3 direction, double length) {
      const Vec3 p = from.deepest + length * from.depth * direction;
      if (distance(p, place) > near_) return;
      if (const double depth = depth_at(p); depth > at.depth) at = {place, p, depth};
    };
    try_step(way, steps_of_ball[0]);
    for (const double length : steps_of_ball) {
      if (at.depth > good_step * from.depth) break;
      for (const Vec3 direction : around) try_step(direction, length);
      if (at.depth > worthwhile_step * from.depth) break;
    }
    if (!(at.depth > worthwhile_step * from.depth)) break;
  }
  return at;
}

} // namespace isoscope
