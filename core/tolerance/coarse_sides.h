// The sides of an input on a coarse lattice: what finer ones ask which side they begin on.
#pragma once

#include "base/status.h"
#include "tolerance/tolerance_volume.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// What is known of an input and its sides.
struct SidedInput {
  const ToleranceField& field;
  const InputSides& sides;
  double delta;
  std::span<const Region> regions;

  /// Whether one can ask for the side of a point; else, in rooms and around points, what lies beside it
  /// tells.
  bool tells_sides() const { return sides.rule() != SideRule::rooms && sides.rule() != SideRule::depth; }
  /// Whether two points are on one side because nothing can lie between them, from φ there. Without an input
  /// surface it is Ω that divides the sides. Straight across a flat wall both sides of the comparison are
  /// equal: rounding must not decide it.
  bool joined(double phi_a, double phi_b, double gap) const {
    const double reach = field.surface() != nullptr ? phi_a + phi_b : phi_a + phi_b - 2 * delta;
    return reach > gap * (1 + 1e-9);
  }
};

/// φ and side, +1 or -1, of points that fill a box.
class CoarseSides {
 public:
  /// A side spreads from outside the input's bounding box and from the regions' deepest points (their labels)
  /// between neighbours where φ proves that the input does not pass between them; where nothing proves it,
  /// the sides decide. Fails with cancelled when told to.
  static Result<CoarseSides> find(const SidedInput& input, const Box3& box, double spacing,
                                  const RunControl& control);
  /// The side of a point, where one of the points near to it proves it; else 0.
  int side(const SidedInput& input, Vec3 p, double phi) const;
  /// That of the nearest of the points whose side is known.
  int nearest_side(Vec3 p) const;

 private:
  std::array<int, 3> coordinates(std::size_t i) const;
  std::size_t number(std::array<int, 3> c) const;
  Vec3 position(std::array<int, 3> c) const;
  std::array<int, 3> nearest(Vec3 p) const;
  template <class Visit> void for_each_neighbor(std::size_t i, Visit&& visit) const;
  bool spread(const SidedInput& input, const RunControl& control);

  Vec3 low_;
  double spacing_ = 1;
  std::array<int, 3> size_{0, 0, 0};
  std::vector<double> phi_;
  std::vector<std::int8_t> sides_;
};

} // namespace isoscope
