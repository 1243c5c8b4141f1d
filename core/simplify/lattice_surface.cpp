// Cubes near the input by bisection, signs and distances of their lattice points in parallel, then facets
// cube by cube.
#include "simplify/lattice_surface.h"

#include "base/parallel.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace isoscope {
namespace {

/// Digits of h in binary, and of a lattice point's number: with four for the place on an edge they fit a
/// double.
constexpr int edge_bits = 20, number_bits = 20;
/// Places on an edge: from the nearest to one end to the nearest to the other.
constexpr int pieces = 16, nearest = 2;

/// A lattice point: corners of cubes have even numbers, their centres odd ones, in units of h/2.
using LatticePoint = std::array<std::int32_t, 3>;

struct Corner {
  LatticePoint at{};
  double distance = 0;
  bool inside = false;
};

double rounded_edge(double length) {
  int exponent = 0;
  std::frexp(length, &exponent);
  return std::ldexp(std::floor(std::ldexp(length, edge_bits - exponent)), exponent - edge_bits);
}

/// A cube of a power of two of lattice cubes; `at` in lattice cubes.
struct Block {
  LatticePoint at;
  std::int32_t size;
};

class Lattice {
 public:
  Lattice(const ToleranceVolume& volume, double edge, std::size_t most_facets, const RunControl& control)
      : volume_(volume), edge_(edge), most_facets_(most_facets), control_(control) {}

  Result<TriangleMesh> make() {
    if (Status found = find_cubes(); !found) return found.error();
    find_corners();
    std::vector<std::array<std::uint32_t, 4>> tets; // that are cut, by corner
    for (const LatticePoint& cube : cubes_) add_tets(cube, tets);
    if (tets.size() > most_facets_) return too_many();
    if (control_.cancelled()) return stopped();
    return facets(tets);
  }

 private:
  Vec3 place(const LatticePoint& p) const {
    return {p[0] * (edge_ / 2), p[1] * (edge_ / 2), p[2] * (edge_ / 2)};
  }
  static Error stopped() { return {ErrorCode::cancelled, "The run was stopped before there was a Z.", ""}; }
  static Error too_many() {
    return {ErrorCode::unsupported, "A lattice as fine as that has too many facets for the memory.",
            "Choose a larger tolerance, or give more with --memory-limit."};
  }

  /// The cubes whose centre may be the corner of a tetrahedron that is cut: it is within h of φ = 0.
  Status find_cubes() {
    const Box3 domain = volume_.domain();
    constexpr std::int32_t largest = 64;
    std::vector<Block> blocks;
    LatticePoint low{}, high{};
    for (int a = 0; a < 3; ++a) {
      const double from = std::floor(domain.lo[a] / edge_ / largest),
                   to = std::floor(domain.hi[a] / edge_ / largest);
      if (std::max(std::abs(from), std::abs(to)) + 2 > std::ldexp(1.0, number_bits - 1) / largest)
        return Error{ErrorCode::unsupported, "The input lies too far from the origin for an exact lattice.",
                     "Move it nearer, or leave --start lattice out."};
      low[static_cast<std::size_t>(a)] = static_cast<std::int32_t>(from);
      high[static_cast<std::size_t>(a)] = static_cast<std::int32_t>(to);
    }
    for (std::int32_t x = low[0]; x <= high[0]; ++x)
      for (std::int32_t y = low[1]; y <= high[1]; ++y)
        for (std::int32_t z = low[2]; z <= high[2]; ++z)
          blocks.push_back({{x * largest, y * largest, z * largest}, largest});
    for (std::int32_t size = largest;; size /= 2) {
      std::vector<std::uint8_t> near(blocks.size(), 0);
      const double reach = edge_ * (1 + 0.5 * std::sqrt(3.0) * (size - 1)) * (1 + 1e-9);
      parallel_until(blocks.size(), 64, control_, [&](std::size_t i) {
        const LatticePoint& b = blocks[i].at;
        const Vec3 middle = place({2 * b[0] + size, 2 * b[1] + size, 2 * b[2] + size});
        near[i] = volume_.field().closest_within(middle, reach).distance() <= reach ? 1 : 0;
      });
      if (control_.cancelled()) return stopped();
      std::vector<Block> next;
      for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (near[i] == 0) continue;
        const LatticePoint& b = blocks[i].at;
        if (size == 1) {
          cubes_.push_back(b);
          continue;
        }
        const std::int32_t half = size / 2;
        for (std::int32_t k = 0; k < 8; ++k)
          next.push_back(
              {{b[0] + (k & 1) * half, b[1] + (k >> 1 & 1) * half, b[2] + (k >> 2 & 1) * half}, half});
      }
      if (size == 1) return {};
      if (next.size() > most_facets_) return too_many();
      blocks = std::move(next);
    }
  }

  /// Every lattice point of the tetrahedra of the cubes, ascending, with its side and distance.
  void find_corners() {
    std::vector<LatticePoint> points;
    for (const LatticePoint& cube : cubes_)
      for_each_tet(cube, [&](const std::array<LatticePoint, 4>& tet) {
        points.insert(points.end(), tet.begin(), tet.end());
        if (points.size() > (std::size_t{1} << 22)) sort_unique(points);
      });
    sort_unique(points);
    corners_.resize(points.size());
    parallel_until(points.size(), 64, control_, [&](std::size_t i) {
      const Vec3 p = place(points[i]);
      corners_[i] = {points[i], volume_.field().distance(p), volume_.sides().inside(p)};
    });
  }

  /// The tetrahedra that a cube's centre forms with the next centres along the axes.
  template <class Visit> static void for_each_tet(const LatticePoint& cube, Visit&& visit) {
    const LatticePoint centre{2 * cube[0] + 1, 2 * cube[1] + 1, 2 * cube[2] + 1};
    for (std::size_t a = 0; a < 3; ++a) {
      LatticePoint next = centre;
      next[a] += 2;
      std::array<LatticePoint, 4> ring; // the corners of the face between, in turn
      ring.fill(centre);
      for (std::size_t n = 0; n < 4; ++n) {
        ring[n][a] += 1;
        ring[n][(a + 1) % 3] += n == 1 || n == 2 ? 1 : -1;
        ring[n][(a + 2) % 3] += n < 2 ? -1 : 1;
      }
      for (std::size_t n = 0; n < 4; ++n) visit({centre, next, ring[n], ring[(n + 1) % 4]});
    }
  }

  std::uint32_t corner(const LatticePoint& p) const {
    const auto at = std::lower_bound(corners_.begin(), corners_.end(), p,
                                     [](const Corner& c, const LatticePoint& q) { return c.at < q; });
    return static_cast<std::uint32_t>(at - corners_.begin());
  }

  void add_tets(const LatticePoint& cube, std::vector<std::array<std::uint32_t, 4>>& tets) const {
    for_each_tet(cube, [&](const std::array<LatticePoint, 4>& points) {
      std::array<std::uint32_t, 4> tet{};
      for (std::size_t i = 0; i < 4; ++i) tet[i] = corner(points[i]);
      const auto inside = std::count_if(tet.begin(), tet.end(), [&](auto c) { return corners_[c].inside; });
      if (inside != 0 && inside != 4) tets.push_back(tet);
    });
  }

  using Edge = std::pair<std::uint32_t, std::uint32_t>; ///< corners, ascending

  Vec3 zero(const Edge& e) const {
    const Corner &a = corners_[e.first], &b = corners_[e.second];
    const double t = a.distance / (a.distance + b.distance);
    const int k = t >= 0 && t <= 1 // not where both are 0
                      ? std::clamp(static_cast<int>(std::lround(t * pieces)), nearest, pieces - nearest)
                      : pieces / 2;
    const double unit = edge_ / (2 * pieces);
    Vec3 p;
    for (int i = 0; i < 3; ++i)
      p[i] =
          (a.at[static_cast<std::size_t>(i)] * (pieces - k) + b.at[static_cast<std::size_t>(i)] * k) * unit;
    return p;
  }

  TriangleMesh facets(const std::vector<std::array<std::uint32_t, 4>>& tets) const {
    std::vector<Edge> edges;
    for (const auto& tet : tets)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
          if (corners_[tet[i]].inside != corners_[tet[j]].inside)
            edges.push_back(std::minmax(tet[i], tet[j]));
    sort_unique(edges);
    TriangleMesh mesh;
    mesh.points.resize(edges.size());
    parallel_for(edges.size(), 1024, [&](std::size_t i) { mesh.points[i] = zero(edges[i]); });
    const auto vertex = [&](std::uint32_t a, std::uint32_t b) {
      const Edge e = std::minmax(a, b);
      return static_cast<std::uint32_t>(std::lower_bound(edges.begin(), edges.end(), e) - edges.begin());
    };
    for (const auto& tet : tets) add_facets(tet, vertex, mesh);
    return mesh;
  }

  template <class VertexOn>
  void add_facets(const std::array<std::uint32_t, 4>& tet, const VertexOn& vertex, TriangleMesh& mesh) const {
    std::vector<std::uint32_t> inside, outside;
    for (const std::uint32_t c : tet) (corners_[c].inside ? inside : outside).push_back(c);
    std::vector<std::uint32_t> polygon;
    if (inside.size() == 2)
      polygon = {vertex(inside[0], outside[0]), vertex(inside[0], outside[1]), vertex(inside[1], outside[1]),
                 vertex(inside[1], outside[0])};
    else
      for (const std::uint32_t c : inside)
        for (const std::uint32_t d : outside) polygon.push_back(vertex(c, d));
    // Counter-clockwise seen from outside: a corner there is in front of all facets of its tetrahedron.
    const auto& p = mesh.points;
    const Vec3 front = place(corners_[outside[0]].at);
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (dot(cross(p[b] - p[a], p[c] - p[a]), front - p[a]) < 0) std::swap(b, c);
      mesh.triangles.push_back({a, b, c});
    };
    if (polygon.size() == 3) return add(polygon[0], polygon[1], polygon[2]);
    const double first = squared_length(p[polygon[0]] - p[polygon[2]]),
                 second = squared_length(p[polygon[1]] - p[polygon[3]]);
    const std::size_t from = first <= second ? 0 : 1;
    add(polygon[from], polygon[from + 1], polygon[from + 2]);
    add(polygon[from], polygon[from + 2], polygon[(from + 3) % 4]);
  }

  const ToleranceVolume& volume_;
  double edge_;
  std::size_t most_facets_;
  const RunControl& control_;
  std::vector<LatticePoint> cubes_;
  std::vector<Corner> corners_; ///< ascending
};

} // namespace

Result<LatticeSurface> lattice_surface(const ToleranceVolume& volume, double ratio, std::size_t most_facets,
                                       const RunControl& control) {
  LatticeSurface made;
  made.edge = rounded_edge(ratio * volume.thresholds().delta);
  auto mesh = Lattice(volume, made.edge, most_facets, control).make();
  if (!mesh) return mesh.error();
  made.mesh = std::move(*mesh);
  return made;
}

} // namespace isoscope
