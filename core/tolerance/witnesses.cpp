// Groups cells beyond δ by their faces, then climbs from the triangles' offsets to what the cells missed.
#include "tolerance/witnesses.h"

#include "base/parallel.h"
#include "tolerance/deep_cells.h"
#include "tolerance/octree_estimate.h"
#include "tolerance/piece_witnesses.h"
#include "tolerance/region_labels.h"
#include "tolerance/regions.h"
#include "tolerance/tolerance_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace isoscope {
namespace {

using CellIndex = Regions::CellIndex;

/// Offsets of triangles start this far beyond δ, relatively.
constexpr double offset_margin = 1e-4;
/// At most about so many triangles are looked at.
constexpr std::size_t most_triangles = 200000;
constexpr std::size_t triangles_per_task = 256;

/// A point beyond δ where no group of cells is.
struct Climbed {
  Vec3 point;
  double depth = 0;
};

/// Every so many triangles that not too many are looked at.
std::vector<TriangleId> some_triangles(const ClosestPointIndex& index) {
  std::vector<TriangleId> some;
  for (std::size_t i = 0; i < index.size(); i += index.size() / most_triangles + 1) some.emplace_back(i);
  return some;
}

/// Of the triangles whose middles lie in a box one in each cell of a lattice and each octant of normals:
/// where they are small, climbs from neighbours come to the same place.
std::vector<TriangleId> spread_triangles(const ClosestPointIndex& index, double side, const Box3& from,
                                         const RunControl& control) {
  using Key = std::array<std::int64_t, 4>;
  std::vector<std::pair<Key, TriangleId>> all;
  SparsePoll poll(control);
  for (std::size_t i = 0; i < index.size() && !poll.cancelled(); ++i) {
    const Triangle3& t = index.triangle(TriangleId(i));
    const Vec3 middle = centroid(t), normal = area_vector(t);
    if (!from.meets({middle, middle})) continue;
    Key key{};
    for (int a = 0; a < 3; ++a) {
      key[static_cast<std::size_t>(a)] =
          static_cast<std::int64_t>(std::floor((middle[a] - index.bounds().lo[a]) / side));
      if (normal[a] < 0) key[3] |= std::int64_t{1} << a;
    }
    all.emplace_back(key, TriangleId(i));
  }
  std::sort(all.begin(), all.end());
  std::vector<TriangleId> some;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i == 0 || all[i].first != all[i - 1].first) some.push_back(all[i].second);
  return some;
}

/// What climbs from both sides of triangles, at distance δ, come to, where that is no group of cells.
std::vector<Climbed> climb_from_triangles(const ClosestPointIndex& index, const DeepCells& cells,
                                          double delta, const std::vector<TriangleId>& from,
                                          const RunControl& control) {
  std::vector<Climbed> found(2 * from.size());
  parallel_until(from.size(), triangles_per_task, control, [&](std::size_t i) {
    const Triangle3& t = index.triangle(from[i]);
    const Vec3 normal = normalized(cross(t[1] - t[0], t[2] - t[0]));
    const Vec3 middle = centroid(t);
    if (normal == Vec3{}) return;
    for (std::size_t side = 0; side < 2; ++side) {
      const double offset = (side == 0 ? 1 : -1) * delta * (1 + offset_margin);
      Vec3 p = middle + offset * normal;
      // Where the input is rough most are too near to another triangle, and any such will do.
      constexpr double least = 1 + 0.5 * offset_margin;
      const ClosestPoint own{middle, squared_length(p - middle), from[i]};
      if (index.closest_near(p, own, delta * least).distance() <= delta * least) continue;
      double depth = 0;
      if (climb(index, cells, delta, index.closest(p), p, depth)) continue;
      found[2 * i + side] = {p, depth};
    }
  });
  std::erase_if(found, [](const Climbed& c) { return !(c.depth > 0); });
  return found;
}

/// Where sides are not known, a ray through a hole counts one crossing too few: there a point belongs to the
/// region that it can escape to, and 0 says that it has none.
int label_of(const ToleranceVolume& volume, Vec3 p) {
  if (const int label = label_above(volume, p); label != 0) return label;
  return volume.sides().known() ? volume.sides().label(p) : 0;
}

/// Climbs that end in the ball of an earlier point, of any type that knows its depth, belong to it.
template <class Points> bool is_known(const Climbed& c, const Points& earlier, double delta) {
  return std::any_of(earlier.begin(), earlier.end(), [&](const auto& o) {
    return distance(c.point, o.point) < std::max(o.depth, c.depth) - delta;
  });
}

} // namespace

std::vector<Witness> find_witnesses(const ToleranceVolume& volume, const RunControl& control) {
  const double delta = volume.thresholds().delta;
  std::vector<Witness> witnesses;
  // Beside open surfaces no region decides.
  const auto beside_sheet = [&](Vec3 p) {
    return volume.open_sides() != nullptr && volume.open_sides()->is_open(volume.field().closest(p).triangle);
  };
  for (const Region& r : volume.regions()) {
    if (r.depth > delta * (1 + offset_margin) && !beside_sheet(r.deepest))
      witnesses.push_back({r.deepest, r.label, r.depth});
  }
  const DeepCells cells(volume.octree(), delta, DeepCells::everywhere, control);
  for (const CellIndex i : cells.deepest(control)) {
    if (control.cancelled()) return witnesses;
    const Regions::Cell c = volume.octree().cell(i);
    const Vec3 p = volume.octree().center(c);
    const double depth = volume.field().distance(p);
    if (depth <= delta * (1 + offset_margin) || beside_sheet(p)) continue;
    if (const int label = label_of(volume, p); label != 0) witnesses.push_back({p, label, depth});
  }
  if (!volume.sides().known() || !volume.has_surface()) return witnesses;
  for (const Climbed& c :
       climb_from_triangles(volume.index(), cells, delta, some_triangles(volume.index()), control)) {
    if (control.cancelled()) break;
    if (!is_known(c, witnesses, delta))
      witnesses.push_back({c.point, volume.sides().label(c.point), c.depth});
  }
  return witnesses;
}

Result<std::vector<Vec3>> witnesses_of_piece(const ClosestPointIndex& piece, double delta, const Box3& within,
                                             const RunControl& control) {
  constexpr double reach = 3, spacing_of_climbs = 0.25; // in δ
  const double boundary = ToleranceVolume::Options().boundary_ratio;
  const double side = OctreeEstimate(piece, true).main_side_ratio(boundary * delta) * boundary * delta;
  auto octree = Regions::build(
      piece, {.boundary = boundary * delta, .main_side = side, .min_side = side, .margin = reach * delta},
      control);
  if (!octree) return octree.error();
  const DeepCells cells(*octree, delta, within.grown((reach - 1) * delta), control);
  std::vector<Climbed> found;
  for (const CellIndex i : cells.deepest(control)) {
    const Vec3 p = octree->center(octree->cell(i));
    if (const double depth = piece.distance(p); depth > delta * (1 + offset_margin))
      found.push_back({p, depth});
  }
  const auto from = spread_triangles(piece, spacing_of_climbs * delta, within, control);
  for (const Climbed& c : climb_from_triangles(piece, cells, delta, from, control)) {
    if (control.cancelled()) break;
    if (!is_known(c, found, delta)) found.push_back(c);
  }
  std::vector<Vec3> points;
  for (const Climbed& c : found) points.push_back(c.point);
  return points;
}

} // namespace isoscope
