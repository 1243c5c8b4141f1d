// Minimax placement: where a vertex must lie so that the largest distance of its star is smallest.
#pragma once

#include "criteria/kernel.h"
#include "improve/border_energy.h"
#include "improve/facet_energy.h"

#include <optional>
#include <span>
#include <vector>

namespace isoscope {

/// The facets around a vertex that may move, in fans: a wedge is (vertex, its rim, that of the next one). A
/// fan closes up, or lies between two edges of the border or of curves.
struct Star {
  struct Wedge {
    Vec3 rim;
    std::span<const Barycentric> extra; ///< of the facet, in its own corner order
    std::span<const SideSample> sides;
    std::uint8_t corner = 0; ///< which corner the vertex is
    TriangleId seed;
    LabelPair labels{+1, -1};
  };
  /// Wedges that follow one another; there are several where sheets meet.
  struct Fan {
    std::size_t begin = 0, end = 0;
    std::optional<Vec3> last; ///< the rim behind its last wedge, where it is open
  };
  std::vector<Wedge> wedges;
  std::vector<Fan> fans;
  /// Where both border edges of an open fan move with the vertex: what they have to keep to.
  const BorderGate* gate = nullptr;
  std::vector<Vec3> rim; ///< samples of the input's rim that one of them has to be near
};

/// The star of wedges found in a complex, in their order; `with_extra` false leaves out what failed checks
/// have added to the facets.
Star make_star(const FacetComplex& complex, std::span<const Wedge> wedges, bool with_extra);
/// Lets the border edges of an open fan move, whose vertex these were, of which the second may be the same.
void move_border(const InputSurface& input, const FacetComplex& complex, std::uint32_t a, std::uint32_t b,
                 Star& star);

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
  /// Judges the star with its vertex at x. May stop once the energy is known to exceed `most_energy`, or some
  /// d `most_distance`; the placement's energy is then infinite, and it is unfit for anything else.
  Placement evaluate(Vec3 x, double most_energy = std::numeric_limits<double>::infinity(),
                     double most_distance = std::numeric_limits<double>::infinity());
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
  static constexpr std::size_t none = ~std::size_t{0};
  /// An edge from the vertex.
  struct Spoke {
    Vec3 rim;
    std::size_t after = none, before = none; ///< the wedges that begin and end there
    std::array<TriangleId, most_steps - 1> edge;
    std::array<TriangleId, most_inner_samples>
        inner; ///< nearest triangles the last time: guesses for the next
    std::vector<TriangleId> extra;
  };

  Vec3 minimax_step(double trust) const;
  DistanceSample sample(Vec3 p, double weight, TriangleId& guess);
  /// Adds the border edges with their vertex at x.
  void add_border(Vec3 x, Placement& placement);
  int longest_steps(std::size_t wedge) const;
  /// Numbers the spokes: one a wedge, and the last of each open fan.
  void number_spokes();
  /// The facet of a wedge with the vertex at x.
  Triangle3 facet(std::size_t wedge, Vec3 x) const {
    return {x, spokes_[first_[wedge]].rim, spokes_[second_[wedge]].rim};
  }
  /// Calls add(wedge) for the wedges on both sides of a spoke.
  template <class Add> void beside(std::size_t spoke, const Add& add) const {
    if (spokes_[spoke].after != none) add(spokes_[spoke].after);
    if (spokes_[spoke].before != none) add(spokes_[spoke].before);
  }

  const InputSurface* input_;
  const Star* star_;
  std::vector<FacetSums> fixed_; ///< by wedge: its rim corners and rim edge
  std::vector<int> rim_steps_;
  std::vector<Spoke> spokes_;
  std::vector<std::size_t> first_, second_; ///< by wedge: its spokes
  TriangleId center_guess_;
  std::vector<FacetSums> sums_;  ///< by wedge, of the last evaluation
  std::vector<double> counts_;   ///< by wedge: its samples
  std::vector<int> spoke_steps_; ///< by spoke: its parts
  std::vector<Linear> linear_, best_linear_;
};

} // namespace isoscope
