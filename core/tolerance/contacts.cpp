// Contacts of a soup: edges and vertices by welded corners, the rest by intersecting pairs of triangles.
#include "tolerance/contacts.h"

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "tolerance/volume_components.h"
#include "tolerance/welded_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <tuple>

namespace isoscope {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// What two triangles have in common is made of points that are rounded once: from points rounded on the way
/// CGAL makes segments that it cannot order.
using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Point = Exact::Point_3;

constexpr std::size_t parallel_grain = 64;

Vec3 vec(const Point& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

/// The triangles by their corners, as numbers of points; without collapsed ones and copies.
class Corners {
 public:
  explicit Corners(const ClosestPointIndex& index) : mesh_(weld(index)) {
    std::vector<std::pair<IndexTriangle, std::uint32_t>> keys;
    for (std::uint32_t t = 0; t < index.size(); ++t) {
      IndexTriangle& own = mesh_.triangles[t];
      std::sort(own.begin(), own.end());
      if (!is_collapsed(own)) keys.emplace_back(own, t);
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < keys.size(); ++i)
      if (i == 0 || keys[i].first != keys[i - 1].first) counting_.push_back(keys[i].second);
    std::sort(counting_.begin(), counting_.end());
  }

  const std::vector<std::uint32_t>& counting() const { return counting_; }
  const IndexTriangle& of(std::uint32_t t) const { return mesh_.triangles[t]; }
  Vec3 point(std::uint32_t v) const { return mesh_.points[v]; }
  std::size_t point_count() const { return mesh_.points.size(); }
  /// The two other corners of a triangle.
  std::array<Vec3, 2> rest(const IndexTriangle& t, std::uint32_t corner) const {
    return {point(t[0] == corner ? t[1] : t[0]), point(t[2] == corner ? t[1] : t[2])};
  }

 private:
  WeldedMesh mesh_;                     ///< the corners of each triangle ascending
  std::vector<std::uint32_t> counting_; ///< ascending
};

/// Edges of more than two triangles and vertices of more than one fan.
void add_shared(const Corners& corners, std::vector<Contact>& contacts) {
  struct Use {
    std::uint32_t low, high, at_low, at_high; ///< with the corners of the triangle there
  };
  const auto& counting = corners.counting();
  std::vector<Use> uses;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> at; ///< vertex, corner
  for (std::uint32_t i = 0; i < counting.size(); ++i) {
    const auto& v = corners.of(counting[i]);
    for (std::uint32_t k = 0; k < 3; ++k) {
      at.emplace_back(v[k], 3 * i + k);
      for (std::uint32_t l = k + 1; l < 3; ++l) uses.push_back({v[k], v[l], 3 * i + k, 3 * i + l});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    return std::tie(a.low, a.high, a.at_low) < std::tie(b.low, b.high, b.at_low);
  });
  DisjointSets fans(3 * counting.size());
  std::vector<char> on_edge(corners.point_count(), 0);
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) {
      fans.unite(uses[i].at_low, uses[end].at_low);
      fans.unite(uses[i].at_high, uses[end].at_high);
      ++end;
    }
    if (end - i < 3) continue;
    contacts.push_back({corners.point(uses[i].low), corners.point(uses[i].high)});
    on_edge[uses[i].low] = on_edge[uses[i].high] = 1;
  }
  std::sort(at.begin(), at.end());
  for (std::size_t i = 1; i < at.size(); ++i) {
    if (at[i].first != at[i - 1].first || on_edge[at[i].first]) continue;
    if (fans.find(at[i].second) == fans.find(at[i - 1].second)) continue;
    on_edge[at[i].first] = 1;
    contacts.push_back({corners.point(at[i].first), corners.point(at[i].first)});
  }
}

template <class K> typename K::Triangle_3 triangle(const Triangle3& t) {
  using P = typename K::Point_3;
  return {P(t[0].x, t[0].y, t[0].z), P(t[1].x, t[1].y, t[1].z), P(t[2].x, t[2].y, t[2].z)};
}

/// Whether two triangles, none of them collapsed, that have the corner `apex` in common, share nothing else
/// as a plane through it shows. Which most do that are neighbours; what they share need not be constructed.
bool meet_in_corner_alone(Vec3 apex, const std::array<Vec3, 2>& own, const std::array<Vec3, 2>& other) {
  const auto point = [](Vec3 p) { return Kernel::Point_3(p.x, p.y, p.z); };
  const auto v = point(apex);
  const std::array a{point(own[0]), point(own[1])}, b{point(other[0]), point(other[1])};
  const int first = CGAL::orientation(v, a[0], a[1], b[0]), second = CGAL::orientation(v, a[0], a[1], b[1]);
  if (first * second > 0) return true;
  if (first == 0 && second == 0) {
    const auto is_apart = [&](const auto& x, const auto& y) { // by the line of one of x's edges
      for (const std::size_t i : {0u, 1u})
        if (CGAL::coplanar_orientation(v, x[i], x[1 - i], y[0]) == CGAL::NEGATIVE &&
            CGAL::coplanar_orientation(v, x[i], x[1 - i], y[1]) == CGAL::NEGATIVE)
          return true;
      return false;
    };
    return is_apart(a, b) || is_apart(b, a);
  }
  if (CGAL::orientation(v, b[0], b[1], a[0]) * CGAL::orientation(v, b[0], b[1], a[1]) > 0) return true;
  for (const std::size_t i : {0u, 1u})
    for (const std::size_t j : {0u, 1u})
      if (CGAL::orientation(v, a[i], b[j], a[1 - i]) * CGAL::orientation(v, a[i], b[j], b[1 - j]) < 0)
        return true;
  return false;
}

void add_intersection(const Triangle3& own, const Triangle3& other, std::vector<Contact>& found) {
  const auto quick = triangle<Kernel>(own), quick_other = triangle<Kernel>(other);
  if (quick.is_degenerate() || quick_other.is_degenerate() || !CGAL::do_intersect(quick, quick_other)) return;
  const auto common = CGAL::intersection(triangle<Exact>(own), triangle<Exact>(other));
  if (!common) return;
  if (const auto* point = boost::get<Point>(&*common)) {
    found.push_back({vec(*point), vec(*point)});
  } else if (const auto* segment = boost::get<Exact::Segment_3>(&*common)) {
    found.push_back({vec(segment->source()), vec(segment->target())});
  } else if (const auto* part = boost::get<Exact::Triangle_3>(&*common)) {
    for (int k = 0; k < 3; ++k) found.push_back({vec(part->vertex(k)), vec(part->vertex(k + 1))});
  } else if (const auto* polygon = boost::get<std::vector<Point>>(&*common)) {
    for (std::size_t k = 0; k < polygon->size(); ++k)
      found.push_back({vec((*polygon)[k]), vec((*polygon)[(k + 1) % polygon->size()])});
  }
}

} // namespace

std::vector<Contact> find_contacts(const ClosestPointIndex& index, const RunControl& control) {
  const Corners corners(index);
  std::vector<Contact> contacts;
  add_shared(corners, contacts);
  const auto& counting = corners.counting();
  std::vector<std::vector<Contact>> found(counting.size());
  parallel_until(counting.size(), parallel_grain, control, [&](std::size_t i) {
    const std::uint32_t s = counting[i];
    Box3 box;
    for (const Vec3 p : index.triangle(TriangleId(s))) box.add(p);
    for (const TriangleId other : index.triangles_in(box)) {
      if (other.value <= s || !std::binary_search(counting.begin(), counting.end(), other.value)) continue;
      const auto& u = corners.of(s);
      const auto& v = corners.of(other.value);
      const auto common = std::find_first_of(u.begin(), u.end(), v.begin(), v.end());
      const auto shared = std::count_if(
          u.begin(), u.end(), [&](std::uint32_t x) { return std::find(v.begin(), v.end(), x) != v.end(); });
      if (shared > 1) continue;
      if (shared == 1 &&
          meet_in_corner_alone(corners.point(*common), corners.rest(u, *common), corners.rest(v, *common)))
        continue;
      std::vector<Contact> here;
      add_intersection(index.triangle(TriangleId(s)), index.triangle(other), here);
      // The common corner alone is what neighbours have.
      if (shared == 1) std::erase_if(here, [](const Contact& c) { return c[0] == c[1]; });
      found[i].insert(found[i].end(), here.begin(), here.end());
    }
  });
  for (const auto& list : found) contacts.insert(contacts.end(), list.begin(), list.end());
  return contacts;
}

std::vector<Contact> find_near_contacts(const ClosestPointIndex& index, const InputSides& sides, double delta,
                                        double spacing, const RunControl& control) {
  const double gap = touching_gap * delta;
  const std::vector<std::uint32_t> part = find_volume_components(index, 0, control).of_triangle;
  std::vector<std::vector<Contact>> found(index.size());
  parallel_until(index.size(), parallel_grain, control, [&](std::size_t s) {
    const Triangle3& own = index.triangle(TriangleId(s));
    Box3 box;
    for (const Vec3 p : own) box.add(p);
    for (const TriangleId t : index.triangles_in(box.grown(gap))) {
      const Triangle3& other = index.triangle(t);
      if (part[t.index()] == part[s] || !triangles_within(own, other, gap)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 a = own[k], b = own[(k + 1) % 3];
        const double pieces = std::max(1.0, std::ceil(distance(a, b) / spacing));
        for (double i = 0; i < pieces; ++i) {
          const Vec3 p = a + (i / pieces) * (b - a), q = closest_point_on_triangle(p, other);
          const Vec3 middle = 0.5 * (p + q);
          if (distance(p, q) <= gap && !sides.inside(middle)) found[s].push_back({middle, middle});
        }
      }
    }
  });
  std::vector<Contact> contacts;
  for (const auto& list : found) contacts.insert(contacts.end(), list.begin(), list.end());
  return contacts;
}

} // namespace isoscope
