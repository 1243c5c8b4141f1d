// Angle defects, gathered in patches.
#include "run/asymptotic_count.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace isoscope {
namespace {

constexpr double patch_radius = 1;      ///< in δ
constexpr double flat_curvature = 1e-6; ///< |K| δ² below which a patch is flat: radii beyond 1000 δ
constexpr double most_flat = 0.25, most_creased = 0.05; ///< shares of the area
const double crease_cosine = std::cos(30 * std::numbers::pi / 180);
/// Vertices of the input for each of the optimum.
constexpr double least_fineness = 2;

/// What a patch or a vertex has of the surface.
struct Part {
  double defect = 0, area = 0; ///< ∫K, area
};

double angle_at(Vec3 p, Vec3 a, Vec3 b) {
  return std::atan2(length(cross(a - p, b - p)), dot(a - p, b - p));
}

/// Neighbours of all vertices, one after the other.
struct Neighbors {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> vertex;

  explicit Neighbors(const TriangleSoup& surface) : begin(surface.points.size() + 1, 0) {
    for (const auto& t : surface.triangles)
      for (const std::uint32_t v : t) ++begin[v + 1];
    for (std::size_t v = 0; v + 1 < begin.size(); ++v) begin[v + 1] += begin[v];
    vertex.resize(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    // On a closed surface each edge leads away from either end once.
    for (const auto& t : surface.triangles)
      for (std::size_t k = 0; k < 3; ++k) vertex[next[t[k]]++] = t[(k + 1) % 3];
  }
};

std::vector<Part> parts_of_vertices(const TriangleSoup& surface) {
  std::vector<Part> parts(surface.points.size(), Part{2 * std::numbers::pi, 0});
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle3 t = surface.triangle(i);
    for (std::size_t k = 0; k < 3; ++k) {
      Part& part = parts[surface.triangles[i][k]];
      part.defect -= angle_at(t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
      part.area += area(t) / 3;
    }
  }
  for (Part& part : parts)
    if (part.area == 0) part.defect = 0;
  return parts;
}

/// The area at edges that turn by much.
double creased_area(const TriangleSoup& surface) {
  struct Half {
    std::uint32_t a, b, triangle;
    auto key() const { return std::tuple(std::min(a, b), std::max(a, b), triangle); }
  };
  std::vector<Half> halves;
  halves.reserve(3 * surface.triangles.size());
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      halves.push_back({surface.triangles[i][k], surface.triangles[i][(k + 1) % 3], i});
  std::sort(halves.begin(), halves.end(), [](const Half& x, const Half& y) { return x.key() < y.key(); });
  const auto normal = [&](std::uint32_t i) {
    const Triangle3 t = surface.triangle(i);
    return normalized(cross(t[1] - t[0], t[2] - t[0]));
  };
  std::vector<std::uint8_t> creased(surface.triangles.size(), 0);
  for (std::size_t i = 0; i + 1 < halves.size(); ++i) {
    const Half &x = halves[i], &y = halves[i + 1];
    if (std::minmax(x.a, x.b) != std::minmax(y.a, y.b)) continue;
    // Both run the same way where the triangles do not agree.
    const double turned = (x.a == y.b ? 1 : -1) * dot(normal(x.triangle), normal(y.triangle));
    if (turned < crease_cosine) creased[x.triangle] = creased[y.triangle] = 1;
  }
  double sum = 0;
  for (std::size_t i = 0; i < creased.size(); ++i)
    if (creased[i] != 0) sum += area(surface.triangle(i));
  return sum;
}

} // namespace

std::optional<AsymptoticCount> asymptotic_count(const TriangleSoup& surface, long euler_characteristic,
                                                double delta) {
  if (surface.triangles.empty() || !(delta > 0)) return std::nullopt;
  const double whole = surface.area();
  if (creased_area(surface) > most_creased * whole) return std::nullopt;
  const std::vector<Part> parts = parts_of_vertices(surface);
  const auto used = std::count_if(parts.begin(), parts.end(), [](const Part& p) { return p.area > 0; });
  if (used - static_cast<long>(surface.triangles.size() / 2) != euler_characteristic) return std::nullopt;
  const Neighbors neighbors(surface);
  std::vector<std::uint8_t> taken(parts.size(), 0);
  std::vector<std::uint32_t> patch;
  AsymptoticCount count;
  double flat = 0;
  for (std::uint32_t seed = 0; seed < parts.size(); ++seed) {
    if (taken[seed] != 0 || parts[seed].area == 0) continue;
    patch.assign(1, seed);
    taken[seed] = 1;
    Part sum;
    for (std::size_t i = 0; i < patch.size(); ++i) {
      const std::uint32_t v = patch[i];
      sum.defect += parts[v].defect;
      sum.area += parts[v].area;
      for (std::size_t n = neighbors.begin[v]; n < neighbors.begin[v + 1]; ++n) {
        const std::uint32_t w = neighbors.vertex[n];
        if (taken[w] != 0 || distance(surface.points[w], surface.points[seed]) > patch_radius * delta)
          continue;
        taken[w] = 1;
        patch.push_back(w);
      }
    }
    if (std::abs(sum.defect) * delta * delta < flat_curvature * sum.area) flat += sum.area;
    (sum.defect > 0 ? count.elliptic : count.hyperbolic) += std::sqrt(std::abs(sum.defect) * sum.area);
  }
  if (flat > most_flat * whole) return std::nullopt;
  const double facets =
      count.elliptic / (3 * std::numbers::sqrt3 * delta) + count.hyperbolic / (2 * std::sqrt(5.) * delta);
  count.vertices = facets / 2 + static_cast<double>(euler_characteristic);
  if (static_cast<double>(surface.points.size()) < least_fineness * count.vertices) return std::nullopt;
  return count;
}

} // namespace isoscope
