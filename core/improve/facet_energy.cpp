// Sampling of facets. Neighbours share the samples of their common edge.
#include "improve/facet_energy.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

constexpr double least_cosine = 0.1;
constexpr double fold_penalty = 1e4;
/// Where input normals cancel to less than this share of their number there is no direction to fold from.
constexpr double clear_direction = 0.3;

double power_12(double x) {
  const double x2 = x * x, x4 = x2 * x2;
  return x4 * x4 * x4;
}

/// The points inside of a triangle whose edges are cut into n parts.
template <int n> constexpr auto inner_lattice() {
  std::array<Barycentric, (n - 1) * (n - 2) / 2> points{};
  std::size_t count = 0;
  for (int i = 1; i < n; ++i)
    for (int j = 1; i + j < n; ++j) points[count++] = {double(i) / n, double(j) / n, double(n - i - j) / n};
  return points;
}

} // namespace

double FacetSums::add(const DistanceSample& s, const InputSurface& input) {
  normal += input.normal(s.triangle);
  return add(s.distance, input);
}

double FacetSums::add(double d, const InputSurface& input) {
  const double own = power_12(d / input.delta());
  energy += own;
  largest = std::max(largest, d);
  ++count;
  return own;
}

Barycentric weights_of(Vec3 p, const Triangle3& t) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double area2 = squared_length(n);
  if (!(area2 > 0)) return {1. / 3, 1. / 3, 1. / 3};
  const double a = dot(n, cross(t[1] - p, t[2] - p)) / area2, b = dot(n, cross(t[2] - p, t[0] - p)) / area2;
  return {a, b, 1 - a - b};
}

SideDistance side_distance(const SideSample& side, const Triangle3& t, double delta) {
  const Vec3 normal = normalized(cross(t[1] - t[0], t[2] - t[0]));
  const double height = side.label * dot(normal, side.point - t[0]);
  return {std::clamp(delta - height, 0., 1.5 * delta), side.label * normal, weights_of(side.point, t)};
}

int sampling_steps(double edge_length, double delta) {
  return std::clamp(static_cast<int>(std::ceil(std::min(edge_length / (4 * delta), double{most_steps}))), 2,
                    most_steps);
}

std::span<const Barycentric> inner_samples(int steps) {
  static constexpr auto of_3 = inner_lattice<3>();
  static constexpr auto of_4 = inner_lattice<4>();
  static constexpr auto of_5 = inner_lattice<5>();
  static constexpr auto of_6 = inner_lattice<6>();
  switch (steps) {
  case 3:
    return of_3;
  case 4:
    return of_4;
  case 5:
    return of_5;
  case 6:
    return of_6;
  default:
    return {};
  }
}

FacetQuality judge(const FacetSums& sums, const Triangle3& facet, double delta) {
  FacetQuality quality{sums.energy / sums.count, sums.largest, false};
  const Vec3 area = cross(facet[1] - facet[0], facet[2] - facet[0]);
  const double twice_area = length(area), clear = length(sums.normal);
  const double longest =
      std::sqrt(std::max({squared_length(facet[1] - facet[0]), squared_length(facet[2] - facet[1]),
                          squared_length(facet[0] - facet[2])}));
  double cosine = -1;
  const double height = longest > 0 ? twice_area / longest : 0;
  if (height >= 1e-4 * longest && height >= 1e-6 * delta)
    cosine = clear < clear_direction * sums.count ? 1 : dot(area, sums.normal) / (twice_area * clear);
  if (cosine < least_cosine) {
    quality.folded = true;
    quality.energy += fold_penalty * (1 + least_cosine - cosine);
  }
  return quality;
}

FacetQuality measure_facet(const InputSurface& input, const Triangle3& t, std::span<const Barycentric> extra,
                           std::span<const SideSample> sides, TriangleId& seed, LabelPair labels) {
  FacetSums sums;
  const auto add = [&](Vec3 p) {
    const DistanceSample s = input.sample(p, seed);
    seed = s.triangle;
    sums.add(s, input);
  };
  int most = 2;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = t[k], b = t[(k + 1) % 3];
    const int steps = sampling_steps(distance(a, b), input.delta());
    most = std::max(most, steps);
    add(a);
    for (int j = 1; j < steps; ++j) add(a + (j / static_cast<double>(steps)) * (b - a));
  }
  for (const Barycentric& w : inner_samples(most)) add(at(w, t));
  for (const Barycentric& w : extra) add(at(w, t));
  for (const SideSample& side : sides) sums.add(side_distance(side, t, input.delta()).distance, input);
  if (input.rooms().samples != nullptr)
    for (const std::int8_t label : {labels.front, labels.back})
      for (const Vec3 p : {t[0], t[1], t[2], centroid(t)}) sums.add(input.rooms().at(p, label).value, input);
  return judge(sums, t, input.delta());
}

double energy_of_sample(const InputSurface& input, const Triangle3& t, double d, std::size_t others) {
  std::size_t count = others + (input.rooms().samples != nullptr ? 8 : 0);
  int most = 2;
  for (std::size_t k = 0; k < 3; ++k) {
    const int steps = sampling_steps(distance(t[k], t[(k + 1) % 3]), input.delta());
    most = std::max(most, steps);
    count += static_cast<std::size_t>(steps);
  }
  return power_12(d / input.delta()) / static_cast<double>(count + inner_samples(most).size());
}

void measure_facet(const InputSurface& input, FacetComplex& complex, std::uint32_t f) {
  Facet& facet = complex.facets[f];
  const FacetQuality quality =
      measure_facet(input, complex.triangle(facet), facet.extra, facet.sides, facet.seed, facet.labels);
  facet.energy = quality.energy;
  facet.largest = quality.largest;
  facet.folded = quality.folded;
}

} // namespace isoscope
