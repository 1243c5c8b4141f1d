// The bracket: flat faces with holes, cut into as few triangles as a CAD program would, and the walls between
// them.
#include "input/ear_clipping.h"
#include "input/exact_circle.h"
#include "input/gallery_shapes.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

namespace isoscope {

namespace {

using Index = std::uint32_t;
using Loop = std::vector<Index>;

/// Collects triangles whose corners are welded where their coordinates are equal.
class Workpiece {
 public:
  Index vertex(Vec3 p) {
    const auto [place, fresh] =
        ids_.try_emplace(std::tuple{p.x, p.y, p.z}, static_cast<Index>(model_.points.size()));
    if (fresh) model_.points.push_back(p);
    return place->second;
  }

  Loop loop(const std::vector<Vec3>& points) {
    Loop ids;
    for (const Vec3 p : points) ids.push_back(vertex(p));
    return ids;
  }

  /// A flat face: the outline counter-clockwise seen from outside, the holes clockwise.
  void face(Loop outline, const std::vector<Loop>& holes) {
    for (const Loop& hole : holes) bridge(outline, hole);
    clip_ears(model_.points, outline, model_.triangles);
  }

  /// The wall between two loops of equal length, seen from outside `lower` running to the right under
  /// `upper`.
  void wall(const Loop& lower, const Loop& upper, bool closed) {
    const std::size_t n = lower.size();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
      const std::size_t j = (i + 1) % n;
      model_.triangles.push_back({lower[i], lower[j], upper[j]});
      model_.triangles.push_back({lower[i], upper[j], upper[i]});
    }
  }

  TriangleSoup take() { return std::move(model_); }

 private:
  /// Splices `hole` into `outline` along the shortest connection between their vertices; with the holes apart
  /// from each other and from the outline, as here, nothing lies across it.
  void bridge(Loop& outline, const Loop& hole) {
    std::size_t best_outer = 0, best_inner = 0;
    double best = Box3::inf;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      for (std::size_t k = 0; k < hole.size(); ++k) {
        const double d = squared_length(model_.points[outline[i]] - model_.points[hole[k]]);
        if (d < best) std::tie(best, best_outer, best_inner) = std::tuple{d, i, k};
      }
    }
    Loop joined(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(best_outer) + 1);
    for (std::size_t k = 0; k <= hole.size(); ++k) joined.push_back(hole[(best_inner + k) % hole.size()]);
    joined.insert(joined.end(), outline.begin() + static_cast<std::ptrdiff_t>(best_outer), outline.end());
    outline = std::move(joined);
  }

  TriangleSoup model_;
  std::map<std::tuple<double, double, double>, Index> ids_;
};

std::vector<Vec3> shifted(std::vector<Vec3> points, Vec3 by) {
  for (Vec3& p : points) p += by;
  return points;
}

Loop reversed(Loop loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

/// Points at k = first … last of `segments` a turn on the circle about `center`, from direction u towards v.
std::vector<Vec3> arc(Vec3 center, double radius, Vec3 u, Vec3 v, int segments, int first, int last) {
  std::vector<Vec3> points;
  for (int k = first; k <= last; ++k) {
    const CirclePoint c = circle_point(k, segments);
    points.push_back(center + radius * (c.cosine * u + c.sine * v));
  }
  return points;
}

void add_points(std::vector<Vec3>& to, const std::vector<Vec3>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

} // namespace

TriangleSoup make_bracket(int segments) {
  // A foot plate 0 <= z <= 1 with two holes and rounded front corners, and a lug 0 <= x <= 1 with a round
  // head and one hole.
  constexpr double foot_length = 6, width = 4, thickness = 1, head_height = 4, corner = 1, foot_hole = 0.55,
                   lug_hole = 1.0;
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const Vec3 up = thickness * z, forth = thickness * x;
  const int quarter = segments / 4, half = segments / 2;
  Workpiece part;

  // Foot: the rounded end from (5, 0) around to (5, 4), seen from above counter-clockwise.
  std::vector<Vec3> front = arc({foot_length - corner, corner, 0}, corner, x, y, segments, -quarter, 0);
  add_points(front, arc({foot_length - corner, width - corner, 0}, corner, x, y, segments, 0, quarter));
  const auto foot_circle = [&](double center_y) {
    return arc({foot_length - 1.6, center_y, 0}, foot_hole, x, y, segments, 0, segments - 1);
  };
  const std::vector<std::vector<Vec3>> foot_holes{foot_circle(1.1), foot_circle(width - 1.1)};

  Loop bottom = part.loop(front), top = part.loop(shifted(front, up));
  part.wall(bottom, top, false);
  const Index lower_left = part.vertex({0, 0, 0}), lower_right = part.vertex({0, width, 0});
  const Index inner_left = part.vertex(forth + up), inner_right = part.vertex({thickness, width, thickness});
  std::vector<Loop> bottom_holes, top_holes;
  for (const auto& hole : foot_holes) {
    bottom_holes.push_back(part.loop(hole));
    top_holes.push_back(reversed(part.loop(shifted(hole, up))));
    part.wall(reversed(bottom_holes.back()), top_holes.back(), true);
  }
  Loop top_outline = top;
  top_outline.push_back(inner_right);
  top_outline.push_back(inner_left);
  part.face(top_outline, top_holes);
  Loop bottom_outline = bottom;
  bottom_outline.push_back(lower_right);
  bottom_outline.push_back(lower_left);
  part.face(reversed(bottom_outline), bottom_holes);

  // Lug: its head from (y, z) = (4, 3) over the top to (0, 3), seen from the front counter-clockwise.
  const double radius = width / 2, head_z = head_height - 1;
  const std::vector<Vec3> head = arc({0, radius, head_z}, radius, y, z, segments, 0, half);
  const std::vector<Vec3> eye = arc({0, radius, head_z}, lug_hole, y, z, segments, 0, segments - 1);
  const Loop back_head = part.loop(head), front_head = part.loop(shifted(head, forth));
  part.wall(back_head, front_head, false);
  const Loop back_eye = part.loop(eye), front_eye = reversed(part.loop(shifted(eye, forth)));
  part.wall(reversed(back_eye), front_eye, true);
  Loop front_outline = front_head;
  front_outline.push_back(inner_left);
  front_outline.push_back(inner_right);
  part.face(front_outline, {front_eye});
  Loop back_outline = back_head;
  back_outline.push_back(lower_left);
  back_outline.push_back(lower_right);
  part.face(reversed(back_outline), {back_eye});

  // The two L-shaped cheeks.
  part.face({lower_left, bottom.front(), top.front(), inner_left, front_head.back(), back_head.back()}, {});
  part.face({lower_right, back_head.front(), front_head.front(), inner_right, top.back(), bottom.back()}, {});
  return part.take();
}

} // namespace isoscope
