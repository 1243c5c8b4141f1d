// Ear clipping with the shortest valid cut first.
#include "input/ear_clipping.h"

#include <limits>

namespace isoscope {

namespace {

struct Point2 {
  double x, y;
  friend bool operator==(const Point2&, const Point2&) = default;
};

double signed_area(Point2 a, Point2 b, Point2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class EarClipper {
 public:
  EarClipper(std::span<const Vec3> points, std::span<const std::uint32_t> corners) : size_(corners.size()) {
    Vec3 area;
    const Vec3 origin = points[corners[0]];
    for (std::size_t i = 1; i + 1 < size_; ++i)
      area += cross(points[corners[i]] - origin, points[corners[i + 1]] - origin);
    const Vec3 n = normalized(area);
    const Vec3 axis = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 u = normalized(cross(axis, n)), v = cross(n, u);
    for (std::size_t i = 0; i < size_; ++i) {
      const Vec3 p = points[corners[i]];
      space_.push_back(p);
      plane_.push_back({dot(u, p - origin), dot(v, p - origin)});
      previous_.push_back(i == 0 ? size_ - 1 : i - 1);
      next_.push_back(i + 1 == size_ ? 0 : i + 1);
    }
    reflex_.assign(size_, false);
    ear_.assign(size_, false);
    for (std::size_t i = 0; i < size_; ++i) reflex_[i] = turn(i) <= 0;
    for (std::size_t i = 0; i < size_; ++i) ear_[i] = is_ear(i);
  }

  /// Cuts off one corner and returns it with its neighbours.
  std::array<std::size_t, 3> clip() {
    const std::size_t tip = choose();
    const std::size_t a = previous_[tip], b = next_[tip];
    next_[a] = b;
    previous_[b] = a;
    first_ = a;
    reflex_[tip] = ear_[tip] = false;
    for (const std::size_t i : {a, b}) reflex_[i] = turn(i) <= 0;
    for (const std::size_t i : {a, b}) ear_[i] = is_ear(i);
    return {a, tip, b};
  }

 private:
  double turn(std::size_t i) const { return signed_area(plane_[previous_[i]], plane_[i], plane_[next_[i]]); }

  bool is_ear(std::size_t i) const {
    if (reflex_[i]) return false;
    const std::size_t ia = previous_[i], ib = next_[i];
    const Point2 a = plane_[ia], t = plane_[i], b = plane_[ib];
    for (std::size_t k = next_[ib]; k != ia; k = next_[k]) {
      if (!reflex_[k]) continue;
      const Point2 p = plane_[k];
      if (p == a || p == t || p == b) continue;
      if (signed_area(a, t, p) >= 0 && signed_area(t, b, p) >= 0 && signed_area(b, a, p) >= 0) return false;
    }
    return true;
  }

  /// The ear with the shortest cut; where there is none, the corner with the shortest cut.
  std::size_t choose() const {
    std::size_t best = first_;
    double best_length = std::numeric_limits<double>::infinity();
    bool best_is_ear = false;
    std::size_t i = first_;
    do {
      const double cut = squared_length(space_[next_[i]] - space_[previous_[i]]);
      if ((ear_[i] && !best_is_ear) || (ear_[i] == best_is_ear && cut < best_length)) {
        best = i;
        best_length = cut;
        best_is_ear = ear_[i];
      }
      i = next_[i];
    } while (i != first_);
    return best;
  }

  std::size_t size_, first_ = 0;
  std::vector<Vec3> space_;
  std::vector<Point2> plane_;
  std::vector<std::size_t> previous_, next_;
  std::vector<bool> reflex_, ear_;
};

} // namespace

void clip_ears(std::span<const Vec3> points, std::span<const std::uint32_t> corners,
               std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (corners.size() < 3) return;
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  EarClipper polygon(points, corners);
  for (std::size_t left = corners.size(); left >= 3; --left) {
    const auto [a, tip, b] = polygon.clip();
    triangles.push_back({corners[a], corners[tip], corners[b]});
  }
}

} // namespace isoscope
