// Sampling of the border, both ways.
#include "improve/border_energy.h"

#include "base/sort_unique.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isoscope {
namespace {

constexpr int most_border_steps = 32;

BorderSample towards(Vec3 to, Vec3 from, double weight) {
  const double d = distance(from, to);
  return {d, weight, d > 0 ? (to - from) / d : Vec3{}};
}

} // namespace

BorderSample sample_of_rim(Vec3 rim, const Segment3& edge) {
  const double t = closest_on_segment(rim, edge);
  return towards(point_on(edge, t), rim, 1 - t);
}

int border_steps(const Segment3& edge, double delta) {
  const double parts = std::ceil(distance(edge[0], edge[1]) / delta);
  return static_cast<int>(std::clamp(parts, 2., double{most_border_steps}));
}

BorderSample sample_of_border(const BorderGate& gate, const Segment3& edge, double t) {
  const Vec3 p = point_on(edge, t);
  return towards(p, gate.rim().closest(p).point, 1 - t);
}

void measure_border(const InputSurface& input, FacetComplex& complex, std::uint32_t v) {
  BorderEdge& border = complex.border[v];
  const Segment3 edge{complex.points[v], complex.points[border.next]};
  FacetSums sums;
  const int steps = border_steps(edge, input.delta());
  for (int j = 0; j <= steps; ++j)
    sums.add(sample_of_border(*input.gate(), edge, static_cast<double>(j) / steps).distance, input);
  for (const Vec3 r : border.rim) sums.add(sample_of_rim(r, edge).distance, input);
  border.energy = sums.energy / sums.count;
  border.largest = sums.largest;
}

void measure_border_at(const InputSurface& input, FacetComplex& complex, std::uint32_t v) {
  const std::uint32_t before = complex.border_before(v);
  BorderEdge &first = complex.border[before], &second = complex.border[v];
  const Vec3 p = complex.points[v];
  const Segment3 to_first{p, complex.points[before]}, to_second{p, complex.points[second.next]};
  std::vector<Vec3> samples = std::exchange(first.rim, {});
  samples.insert(samples.end(), second.rim.begin(), second.rim.end());
  second.rim.clear();
  for (const Vec3 r : samples)
    (distance_to(to_first, r) <= distance_to(to_second, r) ? first : second).rim.push_back(r);
  for (const std::uint32_t w : {before, v}) {
    measure_border(input, complex, w);
    complex.border[w].proven = false;
  }
}

std::vector<Vec3> rim_around(const FacetComplex& complex, std::span<const std::uint32_t> vertices) {
  std::vector<std::uint32_t> edges;
  for (const std::uint32_t v : vertices) {
    if (!complex.on_border(v)) continue;
    edges.push_back(v);
    edges.push_back(complex.border_before(v));
  }
  sort_unique(edges);
  std::vector<Vec3> samples;
  for (const std::uint32_t e : edges)
    samples.insert(samples.end(), complex.border[e].rim.begin(), complex.border[e].rim.end());
  return samples;
}

} // namespace isoscope
