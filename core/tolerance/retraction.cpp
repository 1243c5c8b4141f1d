// Cuts {d <= level} into cubes until each has a direction or a place away from which d grows all over it.
#include "tolerance/retraction.h"

#include "base/parallel.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace isoscope {
namespace {

/// Bounds are blunted by this share of a cell for rounding.
constexpr double rounding_slack = 1e-6;
/// Cells are not cut more often than this.
constexpr int most_halvings = 14;
/// Steps in search of a direction.
constexpr int most_turns = 12;
/// A sheet is looked at as a graph where it has no more triangles, and none turned farther away than 45°.
constexpr std::size_t most_of_graph = 80;
constexpr double least_cosine = 0.7072;
/// Coarsest cells that are proven side by side, and the most that one is cut into.
constexpr std::size_t cells_at_once = 512, most_of_cell = 100000;

/// A triangle that may hold what is closest to a point of a cell.
struct Near {
  TriangleId id;
  Vec3 point; ///< of it, closest to the middle of the cell
  double distance = 0;
};

/// A cube by its middle and half of its side.
struct Cube {
  Vec3 middle;
  double half = 0;
};

/// Of the ball around it.
double radius_of(const Cube& cube) {
  return std::sqrt(3.0) * cube.half * (1 + rounding_slack);
}

Cube eighth(const Cube& cube, unsigned k) {
  const double half = 0.5 * cube.half;
  return {cube.middle + Vec3{k & 1u ? half : -half, k & 2u ? half : -half, k & 4u ? half : -half}, half};
}

using Flat = std::array<double, 2>;
using FlatTriangle = std::array<Flat, 3>;

double turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Whether an edge of a triangle, which runs counterclockwise, has all of another on its outer side.
bool parts(const FlatTriangle& t, const FlatTriangle& other, double slack) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Flat &a = t[k], &b = t[(k + 1) % 3];
    if (std::all_of(other.begin(), other.end(), [&](const Flat& p) { return turn(a, b, p) <= slack; }))
      return true;
  }
  return false;
}

class Prover {
 public:
  Prover(const ClosestPointIndex& index, double level)
      : index_(index), level_(level), mesh_(weld(index)), on_border_(mesh_.triangles.size(), 0),
        normals_(mesh_.triangles.size()) {
    for (const EdgeUse& e : border_uses(mesh_.triangles)) {
      const IndexTriangle& t = mesh_.triangles[e.triangle];
      for (unsigned k = 0; k < 3; ++k)
        if (std::minmax(t[k], t[(k + 1) % 3]) == std::minmax(e.low, e.high))
          on_border_[e.triangle] |= static_cast<std::uint8_t>(1u << k);
    }
    for (std::size_t i = 0; i < normals_.size(); ++i)
      normals_[i] = normalized(area_vector(index.triangle(TriangleId(i))));
  }

  /// Whether no point of a cell off the triangles is critical; counts the cells that were looked at.
  bool prove(const Cube& whole, std::size_t most, std::size_t& looked) const {
    std::vector<Near> all;
    const double radius = radius_of(whole);
    const Box3 box = Box3{whole.middle, whole.middle}.grown(level_ + 2 * radius);
    for (const TriangleId id : index_.triangles_in(box)) all.push_back({id, {}, 0});
    return all.empty() || prove(whole, all, 0, most, looked);
  }

 private:
  const ClosestPointIndex& index_;
  double level_;
  WeldedMesh mesh_;
  std::vector<std::uint8_t> on_border_; ///< by triangle: its edges that are, by bits
  std::vector<Vec3> normals_;           ///< by triangle; zero where it has none

  bool prove(const Cube& cube, std::span<const Near> of_parent, int halvings, std::size_t most,
             std::size_t& looked) const {
    if (++looked > most) return false;
    const double radius = radius_of(cube);
    std::vector<Near> near;
    near.reserve(of_parent.size());
    double d = Box3::inf;
    for (const Near& n : of_parent) {
      const Vec3 point = closest_point_on_triangle(cube.middle, index_.triangle(n.id));
      near.push_back({n.id, point, distance(point, cube.middle)});
      d = std::min(d, near.back().distance);
    }
    if (d - radius > level_) return true;
    // A point of the cell within the level has its closest one in this ball.
    const double reach = std::min(d + 2 * radius, level_ + radius) * (1 + rounding_slack);
    std::erase_if(near, [&](const Near& n) { return n.distance > reach; });
    if (meet_in_corner(near) || (d > radius && have_direction(cube.middle, near, reach, radius))) return true;
    if (d < 2 * radius && is_beside_graph(cube.middle, d, radius)) return true;
    if (halvings == most_halvings) return false;
    for (unsigned k = 0; k < 8; ++k)
      if (!prove(eighth(cube, k), near, halvings + 1, most, looked)) return false;
    return true;
  }

  /// Whether all have a corner in common. Each closest point q of a point p sees it, as they are convex, so
  /// that (p - q)(p - corner) >= |p - q|²: away from it d grows.
  bool meet_in_corner(std::span<const Near> near) const {
    const IndexTriangle& first = mesh_.triangles[near.front().id.index()];
    return std::any_of(first.begin(), first.end(), [&](std::uint32_t v) {
      return std::all_of(near.begin(), near.end(), [&](const Near& n) {
        const IndexTriangle& t = mesh_.triangles[n.id.index()];
        return t[0] == v || t[1] == v || t[2] == v;
      });
    });
  }

  /// A lower bound of (c - y) v over the points y of a triangle that are within reach of c: y lies behind the
  /// plane through the closest one across the way there.
  double least_along(Vec3 c, Vec3 v, const Near& n, double reach) const {
    double of_corners = Box3::inf;
    for (const Vec3 p : index_.triangle(n.id)) of_corners = std::min(of_corners, dot(c - p, v));
    const double along = n.distance > 0 ? dot(c - n.point, v) / n.distance : 0;
    const double cap = std::sqrt(std::max(0.0, reach * reach - n.distance * n.distance));
    const double of_cap =
        n.distance * along - cap * (along > 0 ? std::sqrt(std::max(0.0, 1 - along * along)) : 1);
    return std::max(of_corners, of_cap);
  }

  /// Whether there is a direction in which d grows all over the ball around c.
  bool have_direction(Vec3 c, std::span<const Near> near, double reach, double radius) const {
    Vec3 sum;
    const Near& first = *std::min_element(
        near.begin(), near.end(), [](const Near& a, const Near& b) { return a.distance < b.distance; });
    sum = normalized(c - first.point);
    for (int i = 0; i < most_turns; ++i) {
      const Vec3 v = normalized(sum);
      const Near* worst = nullptr;
      double least = Box3::inf;
      for (const Near& n : near)
        if (const double bound = least_along(c, v, n, reach); bound < least) least = bound, worst = &n;
      if (least > radius * (1 + rounding_slack)) return true;
      sum += normalized(c - worst->point);
    }
    return false;
  }

  /// Whether all around the cell is one piece of a sheet, without border and a graph over a plane: its points
  /// are above or below it, and so are all their closest ones from there.
  bool is_beside_graph(Vec3 c, double d, double radius) const {
    // From a closest point the sheet goes on below the point: no farther than √2 its distance at 45°.
    const double reach = (radius + 2.5 * (std::min(d + radius, level_))) * (1 + rounding_slack);
    std::vector<TriangleId> sheet;
    for (const TriangleId id : index_.triangles_in(Box3{c, c}.grown(reach))) {
      const Triangle3& t = index_.triangle(id);
      if (distance(closest_point_on_triangle(c, t), c) > reach) continue;
      if (sheet.size() == most_of_graph || has_border_within(id, c, reach)) return false;
      sheet.push_back(id);
    }
    if (sheet.empty()) return false;
    Vec3 up;
    for (const TriangleId id : sheet) {
      const Vec3 n = area_vector(index_.triangle(id));
      up += dot(n, up) < 0 ? -n : n;
    }
    up = normalized(up);
    if (up == Vec3{}) return false;
    const Vec3 u = normalized(std::abs(up.x) < 0.6 ? cross(up, {1, 0, 0}) : cross(up, {0, 1, 0}));
    const Vec3 w = cross(up, u);
    std::vector<FlatTriangle> flat;
    for (const TriangleId id : sheet) {
      if (std::abs(dot(normals_[id.index()], up)) < least_cosine) return false;
      FlatTriangle f;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 p = index_.triangle(id)[k] - c;
        f[k] = {dot(p, u), dot(p, w)};
      }
      if (turn(f[0], f[1], f[2]) < 0) std::swap(f[1], f[2]);
      flat.push_back(f);
    }
    const double slack = rounding_slack * rounding_slack * reach * reach;
    for (std::size_t i = 0; i < flat.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!parts(flat[i], flat[j], slack) && !parts(flat[j], flat[i], slack)) return false;
    return true;
  }

  bool has_border_within(TriangleId id, Vec3 c, double reach) const {
    const Triangle3& t = index_.triangle(id);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = t[k], b = t[(k + 1) % 3];
      if ((on_border_[id.index()] & (1u << k)) != 0 &&
          distance(closest_point_on_triangle(c, {a, b, b}), c) <= reach)
        return true;
    }
    return false;
  }
};

} // namespace

bool shrinks_onto_triangles(const ClosestPointIndex& index, double level, std::size_t most_cells,
                            const RunControl& control) {
  if (index.size() == 0) return false;
  const Prover prover(index, level);
  const Box3 box = index.bounds().grown(level);
  std::vector<Cube> cells;
  std::size_t looked = 0;
  const auto prove_cells = [&] {
    std::vector<std::size_t> of_cell(cells.size(), 0);
    std::atomic<bool> failed{false};
    const auto stop = [&] { return failed.load(std::memory_order_relaxed) || control.cancelled(); };
    const bool complete = parallel_until(cells.size(), 1, stop, [&](std::size_t i) {
      if (!prover.prove(cells[i], most_of_cell, of_cell[i])) failed = true;
    });
    for (const std::size_t n : of_cell) looked += n;
    cells.clear();
    return complete && !failed && looked <= most_cells;
  };
  // Down to a quarter of the level from the middle, where that is near to the triangles.
  std::vector<Cube> open{{box.center(), 0.5 * box.longest_edge()}};
  while (!open.empty()) {
    const Cube cube = open.back();
    open.pop_back();
    if (!index.closest_within(cube.middle, level + radius_of(cube)).triangle.valid()) continue;
    if (cube.half > 0.25 * level) {
      for (unsigned k = 0; k < 8; ++k) open.push_back(eighth(cube, k));
      continue;
    }
    cells.push_back(cube);
    if (cells.size() == cells_at_once && !prove_cells()) return false;
  }
  return prove_cells();
}

} // namespace isoscope
