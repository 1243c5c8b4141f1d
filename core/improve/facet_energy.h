// How near to the limit a facet is: the mean of (d/δ)^12 over samples of its corners, edges and interior.
#pragma once

#include "improve/facet_complex.h"
#include "improve/input_surface.h"

#include <span>

namespace isoscope {

/// Sums over the samples of one facet.
struct FacetSums {
  double energy = 0;
  double largest = 0;
  Vec3 normal; ///< sum of the input's unit normals
  int count = 0;

  /// Adds a sample and returns its energy.
  double add(const DistanceSample& s, const InputSurface& input);
  double add(double distance, const InputSurface& input);
};

/// What the samples say about a facet.
struct FacetQuality {
  double energy = 0; ///< with a penalty that outweighs every energy when folded
  double largest = 0;
  bool folded = false;
};

/// A test of condition 3 as if it were a distance: δ where the sample lies in the facet's plane, more (at
/// most 1.5 δ) on the wrong side, less on the right one.
struct SideDistance {
  double distance = 0;
  Vec3 direction;   ///< its gradient when the foot moves
  Barycentric foot; ///< the sample's projection to the plane
};
SideDistance side_distance(const SideSample& side, const Triangle3& facet, double delta);

/// Most parts of an edge, and the inner samples that come with them.
constexpr int most_steps = 6;
constexpr std::size_t most_inner_samples = (most_steps - 1) * (most_steps - 2) / 2;
/// Parts that an edge of this length is cut into for sampling: 2 to most_steps, one for every 4 δ.
int sampling_steps(double edge_length, double delta);
/// Inner samples of a facet whose longest edge has this many parts.
std::span<const Barycentric> inner_samples(int steps);
/// Judges a facet. It is folded when its normal and the mean input normal of its samples have cosine < 0.1,
/// or when it is too thin to have a normal.
FacetQuality judge(const FacetSums& sums, const Triangle3& facet, double delta);
/// Samples and judges a facet, which lies between two labels; `seed` is where the searches start and is
/// replaced by the last triangle found.
FacetQuality measure_facet(const InputSurface& input, const Triangle3& facet,
                           std::span<const Barycentric> extra, std::span<const SideSample> sides,
                           TriangleId& seed, LabelPair labels = {+1, -1});
/// What a sample of such a distance alone adds to the energy of a facet that has at most `others` besides
/// those of its place.
double energy_of_sample(const InputSurface& input, const Triangle3& facet, double distance,
                        std::size_t others);
/// The same for a facet of a complex, stored in it.
void measure_facet(const InputSurface& input, FacetComplex& complex, std::uint32_t f);

/// Barycentric coordinates of p's projection to the triangle's plane; the centroid's for a degenerate one.
Barycentric weights_of(Vec3 p, const Triangle3& t);
inline Vec3 at(const Barycentric& w, const Triangle3& t) {
  return w[0] * t[0] + w[1] * t[1] + w[2] * t[2];
}

} // namespace isoscope
