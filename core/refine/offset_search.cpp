// Halves edges and facets of one label until no part of them can be on the other side.
#include "refine/offset_search.h"

#include "refine/simplices.h"

#include "base/parallel.h"

#include <algorithm>
#include <optional>
#include <utility>

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

std::vector<MisclassifiedPoint> OffsetSearch::find(const LiveTriangulation& live, const OuterOffset& offset,
                                                   const Limits& limits, const RunControl& control) {
  const Complex& complex = live.complex();
  const std::vector<Simplex<3>> parts = parts_of_one_label(complex);
  const std::vector<Part> before = limits == limits_ ? std::move(known_) : std::vector<Part>();
  known_.assign(parts.size(), {});
  parallel_until(parts.size(), grain, control, [&](std::size_t i) {
    const auto& v = parts[i].v;
    known_[i].vertices = v;
    const auto at =
        std::lower_bound(before.begin(), before.end(), v,
                         [](const Part& part, const auto& other) { return part.vertices < other; });
    if (at != before.end() && at->vertices == v) {
      known_[i].farthest = at->farthest;
      return;
    }
    FarthestPoint farthest(offset, complex.value(v[0]) > 0 ? -1 : +1, limits.level, limits.smallest_part);
    farthest.look({complex.position(v[0]), complex.position(v[1]), complex.position(v[2])});
    if (farthest.point()) known_[i].farthest = {*farthest.point(), farthest.distance_beyond()};
  });
  limits_ = control.cancelled() ? Limits{} : limits;
  std::vector<MisclassifiedPoint> points;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (const auto& found = known_[i].farthest) {
      const int label = complex.value(parts[i].v[0]) > 0 ? -1 : +1;
      points.push_back({found->point, label, found->beyond, found->point, found->beyond, parts[i].tet});
    }
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.height > b.height; });
  return points;
}

} // namespace isoscope
