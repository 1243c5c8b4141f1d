// Points are located with perturbed predicates: each belongs to one tetrahedron.
#include "collapse/star_location.h"

#include "mesh/predicates.h"
#include "mesh/sample_sets.h"

namespace isoscope {

StarLocation locate_before(const EdgeStar& star, Vec3 x) {
  for (const EdgeStar::StarTet& t : star.tets) {
    const auto p = star.positions(t);
    if (holds_perturbed(p, x)) return {&t, p};
  }
  return {};
}

StarLocation locate_after(const EdgeStar& star, Vec3 target, Vec3 x) {
  for (const EdgeStar::StarTet& t : star.tets) {
    if (t.ring()) continue;
    const auto p = star.positions_after(t, target);
    if (holds_perturbed(p, x)) return {&t, p};
  }
  return {};
}

std::array<double, 4> values_after(const EdgeStar& star, const EdgeStar::StarTet& t) {
  std::array<double, 4> f = star.values(t);
  for (std::size_t k = 0; k < 4; ++k) {
    if (t.v[k] < 2) f[k] = star.vertices[0].value;
  }
  return f;
}

double sample_error_at(const EdgeStar& star, const StarLocation& at, const std::array<double, 4>& values,
                       Vec3 x, int label) {
  const double f = interpolate(at.corners, values)(x);
  return star.form == ZeroForm::embedded ? embedded_sample_error(f, label, at.tet->side)
                                         : sample_error(f, label);
}

double side_at(const EdgeStar& star, const StarLocation& at, const std::array<double, 4>& values, Vec3 x) {
  return star.form == ZeroForm::embedded ? at.tet->side : interpolate(at.corners, values)(x);
}

} // namespace isoscope
