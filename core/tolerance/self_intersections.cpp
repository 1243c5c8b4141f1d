// Facets whose boxes meet are tested with CGAL's exact predicates, in strips of space at once. Its own test
// of a mesh cannot be stopped.
#include "tolerance/self_intersections.h"

#include "base/parallel.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <atomic>

namespace isoscope {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Corners = std::array<std::uint32_t, 3>;
using FacetBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

constexpr std::uint32_t tests_between_questions = 64;
/// Facets of a strip, about.
constexpr std::size_t strip_facets = 16384;
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

  /// Whether a facet has no area; it is kept as a pair with itself then, where that counts.
  bool flat(std::uint32_t f, bool counts) {
    ask();
    const Corners& c = facets_[f];
    if (!CGAL::collinear(point(c[0]), point(c[1]), point(c[2]))) return false;
    if (counts) keep(f, f);
    return true;
  }
  void test(std::uint32_t f, std::uint32_t g) {
    ask();
    if (meet(facets_[f], facets_[g])) keep(std::min(f, g), std::max(f, g));
  }
  bool stopped() const { return stopped_; }
  std::vector<FacetPair> take() { return std::move(pairs_); }

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

Box3 box_of(std::span<const Vec3> points, const Corners& facet) {
  Box3 box;
  for (const std::uint32_t v : facet) box.add(points[v]);
  return box;
}

/// Cuts space across an axis into strips with about as many facets each, and tells which facets reach into
/// each.
class Strips {
 public:
  Strips(std::span<const Vec3> points, std::span<const Corners> facets) : points_(points), facets_(facets) {
    Box3 bounds;
    for (const Corners& f : facets) bounds.add(box_of(points, f));
    const Vec3 extent = facets.empty() ? Vec3{} : bounds.extent();
    axis_ = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::size_t count = facets.size() / strip_facets + 1;
    std::vector<double> lows;
    for (std::size_t f = 0; f < facets.size() && count > 1; ++f) lows.push_back(low(f));
    std::sort(lows.begin(), lows.end());
    for (std::size_t i = 1; i < count; ++i) cuts_.push_back(lows[i * lows.size() / count]);
    cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
    begins_.assign(size() + 1, 0);
    for (std::size_t f = 0; f < facets.size(); ++f)
      for (std::size_t i = at(low(f)), end = at(high(f)); i <= end; ++i) ++begins_[i + 1];
    for (std::size_t i = 0; i < size(); ++i) begins_[i + 1] += begins_[i];
    members_.resize(begins_.back());
    std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
    for (std::uint32_t f = 0; f < facets.size(); ++f)
      for (std::size_t i = at(low(f)), end = at(high(f)); i <= end; ++i) members_[next[i]++] = f;
  }

  std::size_t size() const { return cuts_.size() + 1; }
  std::span<const std::uint32_t> members(std::size_t strip) const {
    return std::span(members_).subspan(begins_[strip], begins_[strip + 1] - begins_[strip]);
  }
  /// The one strip that counts a pair of facets that reach into it; that of a facet, for f = g.
  std::size_t of(std::uint32_t f, std::uint32_t g) const { return at(std::max(low(f), low(g))); }

 private:
  std::size_t at(double x) const {
    return static_cast<std::size_t>(std::upper_bound(cuts_.begin(), cuts_.end(), x) - cuts_.begin());
  }
  double coordinate(std::size_t f, std::size_t k) const { return points_[facets_[f][k]][axis_]; }
  double low(std::size_t f) const { return std::min({coordinate(f, 0), coordinate(f, 1), coordinate(f, 2)}); }
  double high(std::size_t f) const {
    return std::max({coordinate(f, 0), coordinate(f, 1), coordinate(f, 2)});
  }

  std::span<const Vec3> points_;
  std::span<const Corners> facets_;
  int axis_ = 0;
  std::vector<double> cuts_; ///< between strips
  std::vector<std::size_t> begins_;
  std::vector<std::uint32_t> members_;
};

/// Tests the facets of a strip; ends as the tester does.
void test_strip(std::span<const Vec3> points, std::span<const Corners> facets, const Strips& strips,
                std::size_t strip, Tester& tester) {
  const std::span<const std::uint32_t> members = strips.members(strip);
  std::vector<FacetBox> boxes;
  boxes.reserve(members.size());
  for (const std::uint32_t f : members) {
    if (tester.flat(f, strips.of(f, f) == strip)) continue;
    const Box3 box = box_of(points, facets[f]);
    boxes.emplace_back(CGAL::Bbox_3(box.lo.x, box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z), f);
  }
  std::vector<const FacetBox*> order;
  order.reserve(boxes.size());
  for (const FacetBox& box : boxes) order.push_back(&box);
  CGAL::box_self_intersection_d(
      order.begin(), order.end(),
      [&](const FacetBox* a, const FacetBox* b) {
        if (strips.of(a->info(), b->info()) == strip) tester.test(a->info(), b->info());
      },
      cutoff);
}

} // namespace

std::optional<std::vector<FacetPair>> self_intersections(std::span<const Vec3> points,
                                                         std::span<const Corners> facets,
                                                         const std::function<bool()>& stop,
                                                         std::size_t most) {
  const Strips strips(points, facets);
  std::vector<std::vector<FacetPair>> found(strips.size());
  std::atomic<bool> stopped{false};
  // Which pairs come first must not be chance: a strip ends by itself, and once there are enough before it.
  std::atomic<std::size_t> last{strips.size()};
  parallel_for(strips.size(), 1, [&](std::size_t strip) {
    if (strip > last.load(std::memory_order_relaxed)) return;
    Tester tester(points, facets, stop, most);
    try {
      test_strip(points, facets, strips, strip, tester);
    } catch (const Ended&) {
      if (tester.stopped()) stopped.store(true, std::memory_order_relaxed);
    }
    found[strip] = tester.take();
    if (found[strip].size() < most) return;
    for (std::size_t first = last.load(std::memory_order_relaxed);
         strip < first && !last.compare_exchange_weak(first, strip, std::memory_order_relaxed);) {}
  });
  if (stopped) return std::nullopt;
  std::vector<FacetPair> pairs;
  for (std::size_t strip = 0; strip < strips.size() && pairs.size() < most; ++strip)
    pairs.insert(pairs.end(), found[strip].begin(), found[strip].end());
  pairs.resize(std::min(pairs.size(), most));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace isoscope
