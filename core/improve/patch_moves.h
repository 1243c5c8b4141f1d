// The moves on a complex: merge an edge, relocate a vertex, flip an edge; each leaves its facets measured.
#pragma once

#include "improve/placement.h"
#include "improve/surface_patch.h"

#include <limits>
#include <optional>

namespace isoscope {

/// Where the merged vertex of an edge should lie and what its star would be like.
struct CollapseCandidate {
  Vec3 target;
  double cost = 0; ///< largest sampled d of the star; more when a facet would be folded
};

/// How much work goes into a target.
struct PlacementEffort {
  bool three_starts = true; ///< the best of the midpoint and both ends, or the midpoint alone
  int rounds = 4;
  double folded_surcharge = 3; ///< δ, on the cost where a facet would be folded
  /// Absolute: nothing is placed where the star has a sample farther away at every start.
  double farthest_start = std::numeric_limits<double>::infinity();
};

/// Places the merged vertex of ab, within the kernel if one is given; nothing where the link condition fails
/// or all starts are too far away.
/// Where one end alone is on the border it stays where it is. The stars of a and b must be complete.
std::optional<CollapseCandidate> collapse_candidate(const InputSurface& input, const FacetComplex& complex,
                                                    std::uint32_t a, std::uint32_t b,
                                                    const PlacementEffort& effort,
                                                    const Kernel* kernel = nullptr);
/// Merges b into a at the target and measures the new star.
void collapse_to(const InputSurface& input, SurfacePatch& patch, std::uint32_t a, std::uint32_t b,
                 Vec3 target);
/// Moves v to a better place, in T within its kernel; false where the energy of its star would not fall by
/// half a percent.
bool relocate(const InputSurface& input, SurfacePatch& patch, std::uint32_t v, int rounds);

/// Two facets abc and bad that become adc and dbc.
struct FlipPlan {
  std::uint32_t f = Facet::none, g = Facet::none;
  std::uint32_t a = 0, b = 0, c = 0, d = 0;
  std::array<FacetQuality, 2> quality;
  std::array<std::vector<Barycentric>, 2> extra; ///< where certificates of f and g failed, on the new facets
  std::array<std::vector<SideSample>, 2> sides;
  std::array<TriangleId, 2> seeds;
};

/// Two facets and their edge, from f's k-th corner to its next, as a flip without samples or quality; nothing
/// where the edge has one facet only or is on a curve.
std::optional<FlipPlan> flip_corners(const FacetComplex& complex, std::uint32_t f, std::size_t k);
/// The same for the edge from a to b; nothing where that is none.
std::optional<FlipPlan> flip_of_edge(const FacetComplex& complex, std::uint32_t a, std::uint32_t b);
/// d somewhere on the edge that a flip makes, at a sample that both its facets have.
double distance_of_new_edge(const InputSurface& input, const FacetComplex& complex, const FlipPlan& plan);
/// Whether flipping the edge of f from its k-th to its next corner lowers the energy; asked only where a
/// facet comes near the limit or is folded. Connectivity is the caller's: c and d must not be joined, a and b
/// must keep three facets, one on the border.
std::optional<FlipPlan> plan_flip(const InputSurface& input, const FacetComplex& complex, std::uint32_t f,
                                  std::size_t k);
void apply_flip(FacetComplex& complex, const FlipPlan& plan);
/// Flips the edge ab whatever the energy becomes, and measures both facets, if the connectivity and T allow
/// it and no sample of them is farther away than `most_distance`. a, b and what is opposite must be free.
std::optional<FlipPlan> force_flip(const InputSurface& input, SurfacePatch& patch, std::uint32_t a,
                                   std::uint32_t b, double most_distance);
/// Flips an edge of a patch if that lowers the energy and the connectivity allows it; in T that takes a
/// tetrahedron between the two facets, which changes sides. An edge between two unproven facets is left to
/// the side that runs from the smaller to the larger id.
std::optional<FlipPlan> try_flip(const InputSurface& input, SurfacePatch& patch, std::uint32_t f,
                                 std::size_t k);

} // namespace isoscope
