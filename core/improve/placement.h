// Minimax placement: where a vertex must lie so that the largest distance of its star is smallest.
#pragma once

#include "criteria/kernel.h"
#include "improve/facet_energy.h"

#include <span>
#include <vector>

namespace isoscope {

/// A fan of facets around a vertex that may move: wedge i is (vertex, rim i, rim i + 1).
struct Star {
  struct Wedge {
    Vec3 rim;
    std::span<const Barycentric> extra; ///< of the facet, in its own corner order
    std::span<const SideSample> sides;
    std::uint8_t corner = 0; ///< which corner the vertex is
    TriangleId seed;
  };
  std::vector<Wedge> wedges;
};

/// The star of wedges found in a complex; `with_extra` false leaves out what failed checks
/// have added to the facets.
Star make_star(const FacetComplex& complex, std::span<const Wedge> wedges, bool with_extra);

/// A place for the vertex and what the star is like there.
struct Placement {
  Vec3 point;
  double energy = 0;  ///< sum over the facets
  double largest = 0; ///< largest sampled d
  bool folded = false;
  std::vector<FacetQuality> facets; ///< by wedge
  std::vector<TriangleId> seeds;    ///< by wedge: an input triangle near the facet
};

/// Evaluates one star at many places. Samples that do not move with the vertex are taken once.
class StarEvaluator {
 public:
  StarEvaluator(const InputSurface& input, const Star& star);
  /// Judges the star with its vertex at x. May stop once the energy is known to exceed `most_energy`; the
  /// placement is then unfit for anything else.
  Placement evaluate(Vec3 x, double most_energy = std::numeric_limits<double>::infinity());
  /// Improves a placement that evaluate() just returned by at most `rounds` steps, each of which minimises
  /// the maximum of the linearised distances (p-norms of growing p) and is kept when the true energy falls.
  /// With a kernel, which must contain the placement's point, no step leaves it.
  void improve(Placement& placement, int rounds, const Kernel* kernel = nullptr);

 private:
  /// d of a sample as a function of the vertex's displacement: d + weight · direction · Δ.
  struct Linear {
    double weight;
    DistanceSample sample;
  };
  struct Spoke {
    std::array<TriangleId, most_steps - 1> edge;
    std::array<TriangleId, most_inner_samples>
        inner; ///< nearest triangles the last time: guesses for the next
    std::vector<TriangleId> extra;
  };

  Vec3 minimax_step(double trust) const;
  DistanceSample sample(Vec3 p, double weight, TriangleId& guess);
  int longest_steps(std::size_t wedge) const;
  Vec3 rim(std::size_t i) const { return star_->wedges[i % star_->wedges.size()].rim; }

  const InputSurface* input_;
  const Star* star_;
  std::vector<FacetSums> fixed_; ///< by wedge: its rim corners and rim edge
  std::vector<int> rim_steps_;
  std::vector<Spoke> spokes_;
  TriangleId center_guess_;
  std::vector<FacetSums> sums_;  ///< by wedge, of the last evaluation
  std::vector<double> counts_;   ///< by wedge: its samples
  std::vector<int> spoke_steps_; ///< by wedge: parts of the edge to its rim
  std::vector<Linear> linear_, best_linear_;
};

} // namespace isoscope
