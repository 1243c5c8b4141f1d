// Looks along the edges and across the facets of T for stretches of the input's other side.
#include "refine/misclassified_points.h"

#include "base/parallel.h"
#include "mesh/label_functions.h"
#include "refine/simplices.h"
#include "tolerance/contacts.h"
#include "tolerance/regions.h"
#include "tolerance/room_contacts.h"

#include <algorithm>
#include <optional>

namespace isoscope {
namespace {

constexpr std::size_t simplex_grain = 64;
constexpr int points_per_stretch = 7;
constexpr int climb_steps = 12;
/// The distance along the ray counts as the distance to the input down to this fraction of it.
constexpr double climb_precision = 1 - 1e-6;
/// A summit lower than this, in units of δ', is one in a thin place: above it lies no sample.
constexpr double thin = 1 - 1e-3;
/// Where the climb from a foot on the input starts, in units of δ', and how many feet a triangle has.
constexpr double summit_start = 1e-3;
constexpr std::size_t feet_by_triangle = 4;
/// Leaves of basins are looked at up to this factor above the level that is asked for: what lies far outside
/// of Ω has its side.
constexpr double basin_reach = 4;
/// Facets pierced more often are judged by this many of their piercings.
constexpr std::size_t piercings_considered = 12;

/// 0 over the rim of an open surface, where there is none, and near to closed ones beside it.
int true_label(const ToleranceVolume& volume, Vec3 p) {
  const OpenSides* open = volume.open_sides();
  if (open == nullptr) return volume.sides().label(p);
  const ClosestPoint closest = volume.index().closest(p);
  return open->is_open(closest.triangle) ? open->side(p, closest) : 0;
}

void keep_deeper(std::optional<MisclassifiedPoint>& best, const MisclassifiedPoint& candidate) {
  if (!best || candidate.depth > best->depth) best = candidate;
}

/// The deepest of some points strictly between a and b.
MisclassifiedPoint deepest_between(const ToleranceVolume& volume, Vec3 a, Vec3 b, TetId tet) {
  MisclassifiedPoint best;
  best.tet = tet;
  best.depth = -1;
  for (int k = 1; k <= points_per_stretch; ++k) {
    const Vec3 p = a + (k / (points_per_stretch + 1.0)) * (b - a);
    const double d = volume.index().distance(p);
    if (d <= best.depth) continue;
    best.depth = d;
    best.point = p;
  }
  return best;
}

/// Follows the ray from the closest point through p while the closest point stays the same, no farther than
/// δ'.
void climb(MisclassifiedPoint& point, const ToleranceVolume& volume) {
  point.summit = point.point;
  point.height = point.depth;
  const Vec3 foot = volume.index().closest(point.point).point;
  const Vec3 away = normalized(point.point - foot);
  double low = point.depth, high = std::max(low, volume.thresholds().boundary);
  for (int i = 0; i < climb_steps; ++i) {
    const double t = i == 0 ? high : 0.5 * (low + high);
    const bool straight = volume.index().distance(foot + t * away) >= t * climb_precision;
    (straight ? low : high) = t;
  }
  point.summit = foot + low * away;
  point.height = low;
}

std::optional<MisclassifiedPoint> judge_edge(const LiveTriangulation& live, const ToleranceVolume& volume,
                                             const Simplex<2>& edge) {
  const Complex& complex = live.complex();
  const Vec3 a = complex.position(edge.v[0]), b = complex.position(edge.v[1]);
  const double fa = complex.value(edge.v[0]), fb = complex.value(edge.v[1]);
  const std::vector<double> crossings = volume.index().crossings(a, b);
  std::optional<MisclassifiedPoint> best;
  for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
    MisclassifiedPoint candidate =
        deepest_between(volume, a + crossings[k] * (b - a), a + crossings[k + 1] * (b - a), edge.tet);
    if (best && candidate.depth <= best->depth) continue;
    candidate.label = true_label(volume, candidate.point);
    const double along = distance(candidate.point, a) / distance(a, b);
    if ((fa + along * (fb - fa)) * candidate.label < 0) best = candidate;
  }
  return best;
}

/// Where segment ab pierces triangle t, in floating point.
std::optional<Vec3> piercing(Vec3 a, Vec3 b, const Triangle3& t) {
  const Vec3 u = t[1] - t[0], v = t[2] - t[0], d = b - a;
  const Vec3 h = cross(d, v);
  const double determinant = dot(u, h);
  if (determinant == 0) return std::nullopt;
  const Vec3 s = a - t[0];
  const double x = dot(s, h) / determinant;
  const Vec3 q = cross(s, u);
  const double y = dot(d, q) / determinant, along = dot(v, q) / determinant;
  if (x < 0 || y < 0 || x + y > 1 || along < 0 || along > 1) return std::nullopt;
  return a + along * d;
}

std::vector<Vec3> piercings(const ToleranceVolume& volume, const Triangle3& facet) {
  Box3 box;
  for (const Vec3& p : facet) box.add(p);
  std::vector<Vec3> points;
  for (const TriangleId id : volume.index().triangles_in(box)) {
    const Triangle3& t = volume.index().triangle(id);
    for (std::size_t i = 0; i < 3; ++i) {
      if (const auto p = piercing(t[i], t[(i + 1) % 3], facet)) points.push_back(*p);
    }
  }
  return points;
}

std::optional<MisclassifiedPoint> judge_facet(const LiveTriangulation& live, const ToleranceVolume& volume,
                                              const Simplex<3>& facet) {
  const Complex& complex = live.complex();
  const Triangle3 corners{complex.position(facet.v[0]), complex.position(facet.v[1]),
                          complex.position(facet.v[2])};
  const int label = complex.value(facet.v[0]) > 0 ? +1 : -1;
  const std::vector<Vec3> points = piercings(volume, corners);
  const std::size_t stride = 1 + points.size() / piercings_considered;
  std::optional<MisclassifiedPoint> best;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    for (std::size_t j = i + stride; j < points.size(); j += stride) {
      MisclassifiedPoint candidate;
      candidate.point = 0.5 * (points[i] + points[j]);
      candidate.tet = facet.tet;
      candidate.label = -label;
      candidate.depth = volume.index().distance(candidate.point);
      if (best && candidate.depth <= best->depth) continue;
      if (true_label(volume, candidate.point) == -label) keep_deeper(best, candidate);
    }
  }
  return best;
}

void append(const Complex& complex, TetId t, std::vector<Simplex<2>>& edges) {
  append_edges(complex, t, edges);
}
void append(const Complex& complex, TetId t, std::vector<Simplex<3>>& facets) {
  append_facets_of_one_label(complex, t, facets);
}

std::optional<MisclassifiedPoint> judge(const LiveTriangulation& live, const ToleranceVolume& volume,
                                        const Simplex<2>& edge) {
  return judge_edge(live, volume, edge);
}
std::optional<MisclassifiedPoint> judge(const LiveTriangulation& live, const ToleranceVolume& volume,
                                        const Simplex<3>& facet) {
  return judge_facet(live, volume, facet);
}

} // namespace

template <std::size_t N> void MisclassifiedSearch<N>::forget() {
  found_.clear();
  looked_at_.clear();
}

template <std::size_t N>
std::vector<MisclassifiedPoint> MisclassifiedSearch<N>::find(const LiveTriangulation& live,
                                                             const ToleranceVolume& volume,
                                                             const RunControl& control) {
  const Complex& complex = live.complex();
  looked_at_.resize(complex.tets.size(), 0);
  const auto known = [&](TetId t) { return live.alive(t) && live.generation(t) == looked_at_[t.index()]; };
  std::vector<Simplex<N>> fresh;
  for (std::uint32_t t = 0; t < complex.tets.size(); ++t)
    if (complex.tets[t].alive() && !known(TetId(t))) append(complex, TetId(t), fresh);
  sort_unique(fresh);
  std::vector<std::optional<MisclassifiedPoint>> told(fresh.size());
  parallel_until(fresh.size(), simplex_grain, control, [&](std::size_t i) {
    told[i] = judge(live, volume, fresh[i]);
    if (told[i]) climb(*told[i], volume);
  });
  // What stays of T where a tetrahedron has gone is part of a new one.
  std::vector<Found> all;
  std::size_t next = 0;
  const auto take_told_before = [&](const Found* old) {
    for (; next < fresh.size() && (old == nullptr || fresh[next].v <= old->simplex); ++next)
      if (told[next]) all.push_back({fresh[next].v, *told[next]});
  };
  for (const Found& old : found_) {
    take_told_before(&old);
    const bool looked_at_again = next > 0 && fresh[next - 1].v == old.simplex;
    if (!looked_at_again && known(old.point.tet)) all.push_back(old);
  }
  take_told_before(nullptr);
  found_ = std::move(all);
  for (std::uint32_t t = 0; t < complex.tets.size(); ++t) looked_at_[t] = live.generation(TetId(t));

  std::vector<MisclassifiedPoint> result;
  for (const Found& found : found_) result.push_back(found.point);
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.height > b.height; });
  if (control.cancelled()) forget();
  return result;
}

template class MisclassifiedSearch<2>;
template class MisclassifiedSearch<3>;

std::vector<MisclassifiedPoint> thin_summits(const ToleranceVolume& volume, const RunControl& control) {
  const ClosestPointIndex& index = volume.index();
  const double start = summit_start * volume.thresholds().boundary;
  std::vector<std::array<std::optional<MisclassifiedPoint>, 2 * feet_by_triangle>> found(index.size());
  parallel_until(index.size(), simplex_grain, control, [&](std::size_t i) {
    const Triangle3& t = index.triangle(TriangleId(i));
    const Vec3 normal = normalized(cross(t[1] - t[0], t[2] - t[0]));
    if (normal == Vec3{}) return;
    const std::array<Vec3, feet_by_triangle> feet{centroid(t), 0.5 * (t[0] + t[1]), 0.5 * (t[1] + t[2]),
                                                  0.5 * (t[2] + t[0])};
    for (std::size_t k = 0; k < found[i].size(); ++k) {
      MisclassifiedPoint point;
      point.point = feet[k / 2] + (k % 2 == 0 ? start : -start) * normal;
      point.depth = index.distance(point.point);
      climb(point, volume);
      if (!(point.height >= start) || point.height > thin * volume.thresholds().boundary) continue;
      point.label = true_label(volume, point.summit);
      if (point.label != 0) found[i][k] = point;
    }
  });
  std::vector<MisclassifiedPoint> summits;
  for (const auto& list : found) {
    for (const auto& point : list) {
      if (point) summits.push_back(*point);
    }
  }
  std::stable_sort(summits.begin(), summits.end(),
                   [](const auto& a, const auto& b) { return a.height > b.height; });
  return summits;
}

std::vector<MisclassifiedPoint> misclassified_basins(const LiveTriangulation& live,
                                                     const ToleranceVolume& volume, double level,
                                                     const RunControl& control) {
  const Regions& octree = volume.octree();
  const std::span<const std::int8_t> basins = volume.basins();
  SparsePoll poll(control);
  std::vector<MisclassifiedPoint> points;
  TetId near;
  for (std::size_t i = 0; i < basins.size() && !poll.cancelled(); ++i) {
    const Regions::Cell cell = octree.cell(static_cast<Regions::CellIndex>(i));
    const bool was_leaf = cell.child == Regions::none || cell.child >= basins.size();
    const double height = static_cast<double>(cell.distance);
    if (!was_leaf || basins[i] == 0 || height < level || height > basin_reach * level) continue;
    const Vec3 center = octree.center(cell);
    const TetId t = live.delaunay().locate(center, near);
    if (!t.valid()) continue;
    near = t;
    if (LabelFunctions(live.complex(), t).of(basins[i])(center) > 0) continue;
    points.push_back({center, basins[i], height, center, height, t});
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.height > b.height; });
  return points;
}

std::vector<MisclassifiedPoint> contact_points(const ToleranceVolume& volume, double spacing,
                                               const RunControl& control) {
  std::vector<RoomContact> contacts = room_contacts(volume, control);
  if (!volume.has_rooms()) {
    for (const Contact& contact : find_contacts(volume.index(), control)) contacts.push_back({contact});
    for (const Contact& near :
         find_near_contacts(volume.index(), volume.sides(), volume.thresholds().delta, spacing, control))
      contacts.push_back({near});
  }
  std::vector<MisclassifiedPoint> points;
  for (const auto& [edge, label] : contacts) {
    const auto& [a, b] = edge;
    const double pieces = std::max(1.0, std::ceil(distance(a, b) / spacing));
    for (double k = 0; k <= pieces; ++k) {
      MisclassifiedPoint& point = points.emplace_back();
      point.point = point.summit = a + (k / pieces) * (b - a);
      point.label = label;
      point.height = volume.thresholds().boundary;
    }
  }
  // One of those in a cube of half the spacing.
  const auto cube = [&](const MisclassifiedPoint& m) {
    return std::array{std::floor(2 * m.point.x / spacing), std::floor(2 * m.point.y / spacing),
                      std::floor(2 * m.point.z / spacing)};
  };
  std::stable_sort(points.begin(), points.end(),
                   [&](const auto& m, const auto& n) { return cube(m) < cube(n); });
  points.erase(std::unique(points.begin(), points.end(),
                           [&](const auto& m, const auto& n) { return cube(m) == cube(n); }),
               points.end());
  return points;
}

bool spans_thin_place(const LiveTriangulation& live, const ToleranceVolume& volume, TetId t) {
  const auto edges = edges_of(live.complex().tet(t), t);
  return std::any_of(edges.begin(), edges.end(), [&](const Simplex<2>& edge) {
    std::optional<MisclassifiedPoint> point = judge_edge(live, volume, edge);
    if (!point) return false;
    climb(*point, volume);
    return point->height < thin * volume.thresholds().boundary;
  });
}

} // namespace isoscope
