// Facets whose boxes meet are tested with CGAL's exact predicates. Its own test of a mesh cannot be stopped.
#include "tolerance/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace isoscope {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Corners = std::array<std::uint32_t, 3>;
using FacetBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

constexpr std::uint32_t tests_between_questions = 64;
/// Below so many boxes CGAL compares all of them along one axis.
constexpr std::ptrdiff_t cutoff = 2000;

/// Thrown out of CGAL's search, which has no other way to end.
struct Ended {};

/// Tests pairs of facets and keeps those that meet.
class Tester {
 public:
  Tester(std::span<const Vec3> points, std::span<const Corners> facets, const std::function<bool()>& stop,
         std::size_t most)
      : points_(points), facets_(facets), stop_(stop), most_(most) {}

  /// Whether a facet has no area; it is kept as a pair with itself then.
  bool flat(std::uint32_t f) {
    ask();
    const Corners& c = facets_[f];
    if (!CGAL::collinear(point(c[0]), point(c[1]), point(c[2]))) return false;
    keep(f, f);
    return true;
  }
  void test(std::uint32_t f, std::uint32_t g) {
    ask();
    if (meet(facets_[f], facets_[g])) keep(std::min(f, g), std::max(f, g));
  }
  bool stopped() const { return stopped_; }
  std::vector<FacetPair> take() {
    std::sort(pairs_.begin(), pairs_.end());
    return std::move(pairs_);
  }

 private:
  void ask() {
    if (++calls_ % tests_between_questions != 0 || !stop_()) return;
    stopped_ = true;
    throw Ended();
  }
  void keep(std::uint32_t f, std::uint32_t g) {
    pairs_.emplace_back(f, g);
    if (pairs_.size() >= most_) throw Ended();
  }
  Point point(std::uint32_t v) const { return {points_[v].x, points_[v].y, points_[v].z}; }
  Kernel::Triangle_3 triangle(const Corners& f) const { return {point(f[0]), point(f[1]), point(f[2])}; }

  bool meet(const Corners& f, const Corners& g) const {
    const auto in = [](std::uint32_t v, const Corners& c) {
      return std::find(c.begin(), c.end(), v) != c.end();
    };
    std::array<std::uint32_t, 3> shared{}, own{}, other{};
    std::size_t shared_count = 0, own_count = 0, other_count = 0;
    for (const std::uint32_t v : f) (in(v, g) ? shared[shared_count++] : own[own_count++]) = v;
    for (const std::uint32_t v : g)
      if (!in(v, f)) other[other_count++] = v;
    switch (shared_count) {
    case 3:
      return true;
    case 2: {
      const Point a = point(shared[0]), b = point(shared[1]), p = point(own[0]), q = point(other[0]);
      return CGAL::coplanar(a, b, p, q) && CGAL::coplanar_orientation(a, b, p, q) == CGAL::POSITIVE;
    }
    case 1:
      return CGAL::do_intersect(Kernel::Segment_3(point(own[0]), point(own[1])), triangle(g)) ||
             CGAL::do_intersect(Kernel::Segment_3(point(other[0]), point(other[1])), triangle(f));
    default:
      return CGAL::do_intersect(triangle(f), triangle(g));
    }
  }

  std::span<const Vec3> points_;
  std::span<const Corners> facets_;
  const std::function<bool()>& stop_;
  std::size_t most_;
  std::vector<FacetPair> pairs_;
  std::uint32_t calls_ = 0;
  bool stopped_ = false;
};

} // namespace

std::optional<std::vector<FacetPair>> self_intersections(std::span<const Vec3> points,
                                                         std::span<const Corners> facets,
                                                         const std::function<bool()>& stop,
                                                         std::size_t most) {
  Tester tester(points, facets, stop, most);
  try {
    std::vector<FacetBox> boxes;
    boxes.reserve(facets.size());
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
      if (tester.flat(f)) continue;
      Box3 box;
      for (const std::uint32_t v : facets[f]) box.add(points[v]);
      boxes.emplace_back(CGAL::Bbox_3(box.lo.x, box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z), f);
    }
    std::vector<const FacetBox*> order;
    order.reserve(boxes.size());
    for (const FacetBox& box : boxes) order.push_back(&box);
    CGAL::box_self_intersection_d(
        order.begin(), order.end(),
        [&](const FacetBox* a, const FacetBox* b) { tester.test(a->info(), b->info()); }, cutoff);
  } catch (const Ended&) {
    if (tester.stopped()) return std::nullopt;
  }
  return tester.take();
}

} // namespace isoscope
