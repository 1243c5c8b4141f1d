// The functions f_i of one tetrahedron, each made when it is first asked for (§4.2).
#pragma once

#include "mesh/complex.h"

namespace isoscope {

/// Of two labels they are ±f.
class LabelFunctions {
 public:
  LabelFunctions(const Complex& complex, TetId t)
      : p_(complex.positions(t)), values_(complex.values(t)), labels_(complex.labels(t)) {}

  /// f_i: + where a point belongs to the side i.
  const AffineFunction& of(int label) {
    for (std::size_t k = 0; k < made_; ++k)
      if (made_for_[k] == label) return functions_[k];
    const std::size_t k = made_ < most ? made_++ : most - 1;
    made_for_[k] = label;
    functions_[k] = interpolate(p_, seen_from(label, values_, labels_));
    return functions_[k];
  }

 private:
  static constexpr std::size_t most = 4;
  std::array<Vec3, 4> p_;
  std::array<double, 4> values_;
  TetLabels labels_;
  std::array<int, most> made_for_{};
  std::array<AffineFunction, most> functions_;
  std::size_t made_ = 0;
};

} // namespace isoscope
