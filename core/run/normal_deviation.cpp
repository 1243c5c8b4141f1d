// Measures normals at the centroids of equal pieces of the facets.
#include "run/normal_deviation.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace isoscope {

namespace {

constexpr double wanted_points = 50000;
constexpr double straight_angle = 180;

using Measurement = NormalMeasurement;

/// The vector times a power of two, so that products of it stay in the range of a double at any size of the
/// model.
Vec3 near_one(Vec3 v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0)) return v;
  const int exponent = -std::ilogb(largest);
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

/// Measures at the centroids of the k² congruent pieces of a facet.
void measure_facet(const Triangle3& facet, std::size_t k, const NormalQuestion& question, Measurement* out) {
  const Vec3 area = area_vector(facet), normal = near_one(area);
  const auto pieces = static_cast<double>(k);
  TriangleId guess;
  const auto measure = [&](double u, double v) {
    const Vec3 p = facet[0] + u / pieces * (facet[1] - facet[0]) + v / pieces * (facet[2] - facet[0]);
    Measurement& m = *out++;
    if (question.counts && !question.counts(p)) return;
    guess = question.index.closest_near(p, guess).triangle;
    const Vec3 input = near_one(area_vector(question.index.triangle(guess)));
    if (squared_length(input) == 0) return;
    m.degrees =
        std::atan2(length(cross(normal, input)), dot(normal, input)) * straight_angle / std::numbers::pi;
    m.area = length(area) / (pieces * pieces);
    if (question.component_of) m.component = question.component_of(guess);
  };
  constexpr double near = 1.0 / 3, far = 2.0 / 3;
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; i + j < k; ++j) {
      const auto u = static_cast<double>(i), v = static_cast<double>(j);
      measure(u + near, v + near);
      if (i + j + 1 < k) measure(u + far, v + far);
    }
  }
}

/// Turns the input around in every component of Ω where most of the mesh disagrees with it.
void agree_with_majority(std::vector<Measurement>& measurements, std::size_t components) {
  std::vector<double> balance(components, 0);
  for (const Measurement& m : measurements)
    balance[m.component] += m.degrees <= 0.5 * straight_angle ? m.area : -m.area;
  for (Measurement& m : measurements)
    if (balance[m.component] < 0) m.degrees = straight_angle - m.degrees;
}

/// The least angle that is not exceeded on the given share of the area. Ascending measurements.
double percentile(const std::vector<Measurement>& measurements, double area, double share) {
  double below = 0;
  for (const Measurement& m : measurements) {
    below += m.area;
    if (below >= share * area) return m.degrees;
  }
  return measurements.back().degrees;
}

} // namespace

std::vector<NormalMeasurement> measure_normals(std::span<const Triangle3> facets,
                                               const NormalQuestion& question, const RunControl& control) {
  if (!(question.area > 0)) return {};
  std::vector<std::size_t> pieces(facets.size()), offset(facets.size() + 1, 0);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const double share = length(area_vector(facets[f])) / question.area;
    pieces[f] =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(std::sqrt(wanted_points * share))));
    offset[f + 1] = offset[f] + pieces[f] * pieces[f];
  }
  std::vector<NormalMeasurement> measurements(offset.back());
  const auto stop = [&control] { return control.out_of_grace(); };
  const bool complete = parallel_until(facets.size(), 16, stop, [&](std::size_t f) {
    measure_facet(facets[f], pieces[f], question, measurements.data() + offset[f]);
  });
  if (!complete) return {};
  std::erase_if(measurements, [](const Measurement& m) { return !(m.area > 0); });
  return measurements;
}

NormalDeviation measure_normal_deviation(const TriangleMesh& mesh, const ToleranceVolume& volume,
                                         const RunControl& control) {
  std::vector<Triangle3> facets;
  facets.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    facets.push_back({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
  double area = 0;
  for (const Triangle3& f : facets) area += length(area_vector(f));
  const auto component = [&volume](TriangleId t) { return volume.volume_component(t); };
  return deviation_of(measure_normals(facets, {volume.index(), area, {}, component}, control),
                      volume.input().consistently_oriented, volume.volume_component_count());
}

NormalDeviation deviation_of(std::vector<NormalMeasurement> measurements, bool oriented,
                             std::size_t components) {
  NormalDeviation result;
  result.oriented = oriented;
  result.points = measurements.size();
  if (measurements.empty()) return result;
  if (result.oriented) {
    agree_with_majority(measurements, components);
  } else {
    for (Measurement& m : measurements) m.degrees = std::min(m.degrees, straight_angle - m.degrees);
  }
  std::sort(measurements.begin(), measurements.end(), [](const Measurement& a, const Measurement& b) {
    return a.degrees != b.degrees ? a.degrees < b.degrees : a.area < b.area;
  });

  double area = 0;
  for (const Measurement& m : measurements) area += m.area;
  for (const Measurement& m : measurements) {
    const double share = m.area / area;
    const auto bin = static_cast<std::size_t>(m.degrees / NormalDeviation::bin_degrees);
    result.histogram[std::min(bin, NormalDeviation::bin_count - 1)] += share;
    result.mean += share * m.degrees;
    if (m.degrees > 30) result.above_30 += share;
    if (m.degrees > 90) result.above_90 += share;
  }
  result.percentile_90 = percentile(measurements, area, 0.9);
  result.percentile_99 = percentile(measurements, area, 0.99);
  return result;
}

} // namespace isoscope
