// Halves edges and facets of one label until no part of them can be on the other side.
#include "criteria/outer_offset.h"
#include "refine/misclassified_points.h"
#include "refine/simplices.h"

#include "base/parallel.h"

#include <algorithm>
#include <optional>

namespace isoscope {
namespace {

constexpr std::size_t grain = 64;
/// Of one edge or facet; larger ones are judged by so many parts.
constexpr int most_parts = 4096;

/// Facets, and edges as facets whose last two vertices are one.
std::vector<Simplex<3>> parts_of_one_label(const Complex& complex) {
  std::vector<Simplex<3>> parts = facets_of_one_label(complex);
  for (const auto& [v, tet] : all_edges(complex))
    if ((complex.value(v[0]) > 0) == (complex.value(v[1]) > 0)) parts.push_back({{v[0], v[1], v[1]}, tet});
  sort_unique(parts);
  return parts;
}

/// The point of a triangle, or of a segment given as one, that is farthest on the side `label`.
class FarthestPoint {
 public:
  FarthestPoint(const OuterOffset& offset, int label, double level, double smallest)
      : offset_(offset), label_(label), farthest_(level), smallest_(smallest) {}

  void look(const Triangle3& t) {
    std::vector<Triangle3> left{t};
    for (int n = 0; n < most_parts && !left.empty(); ++n) {
      const Triangle3 part = left.back();
      left.pop_back();
      const Vec3 middle = centroid(part);
      const double beyond = label_ < 0 ? offset_.depth(middle) : -offset_.depth(middle);
      if (beyond >= farthest_) {
        farthest_ = beyond;
        point_ = middle;
      }
      const double radius =
          std::max({distance(middle, part[0]), distance(middle, part[1]), distance(middle, part[2])});
      if (radius < smallest_ || beyond + radius <= farthest_) continue;
      // Across the longest side, so that segments stay segments.
      std::size_t longest = 0;
      for (std::size_t i = 1; i < 3; ++i)
        if (distance(part[i], part[(i + 1) % 3]) > distance(part[longest], part[(longest + 1) % 3]))
          longest = i;
      const Vec3 a = part[longest], b = part[(longest + 1) % 3], c = part[(longest + 2) % 3];
      const Vec3 half = 0.5 * (a + b);
      left.push_back(c == b ? Triangle3{half, b, b} : Triangle3{half, b, c});
      left.push_back(c == b ? Triangle3{a, half, half} : Triangle3{a, half, c});
    }
  }
  const std::optional<Vec3>& point() const { return point_; }
  double distance_beyond() const { return farthest_; }

 private:
  const OuterOffset& offset_;
  int label_;
  double farthest_;
  double smallest_;
  std::optional<Vec3> point_;
};

} // namespace

std::vector<MisclassifiedPoint> misclassified_by_offset(const LiveTriangulation& live,
                                                        const OuterOffset& offset, double level,
                                                        double smallest_part, const RunControl& control) {
  const Complex& complex = live.complex();
  const std::vector<Simplex<3>> parts = parts_of_one_label(complex);
  std::vector<std::optional<MisclassifiedPoint>> found(parts.size());
  parallel_until(parts.size(), grain, control, [&](std::size_t i) {
    const auto& [v, tet] = parts[i];
    const int label = complex.value(v[0]) > 0 ? -1 : +1;
    FarthestPoint farthest(offset, label, level, smallest_part);
    farthest.look({complex.position(v[0]), complex.position(v[1]), complex.position(v[2])});
    if (!farthest.point()) return;
    const double beyond = farthest.distance_beyond();
    found[i] = {*farthest.point(), label, beyond, *farthest.point(), beyond, tet};
  });
  std::vector<MisclassifiedPoint> points;
  for (const auto& point : found)
    if (point) points.push_back(*point);
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.height > b.height; });
  return points;
}

} // namespace isoscope
