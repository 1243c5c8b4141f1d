// Points are located with perturbed predicates: each belongs to one tetrahedron.
#include "collapse/star_location.h"

#include "mesh/predicates.h"
#include "mesh/sample_sets.h"

namespace isoscope {

StarLocation locate_before(const EdgeStar& star, Vec3 x) {
  for (const EdgeStar::StarTet& t : star.tets) {
    const auto p = star.positions(t);
    if (holds_perturbed(p, x)) return {&t, p, star.values(t), star.labels(t)};
  }
  return {};
}

StarLocation locate_after(const EdgeStar& star, Vec3 target, Vec3 x) {
  for (const EdgeStar::StarTet& t : star.tets) {
    if (t.ring()) continue;
    const auto p = star.positions_after(t, target);
    if (holds_perturbed(p, x)) return {&t, p, values_after(star, t), labels_after(star, t)};
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

TetLabels labels_after(const EdgeStar& star, const EdgeStar::StarTet& t) {
  TetLabels labels = star.labels(t);
  for (std::size_t k = 0; k < 4; ++k) {
    if (t.v[k] < 2) labels[k] = star.vertices[0].label();
  }
  return labels;
}

std::array<VertexId, 4> vertices_after(const EdgeStar& star, const EdgeStar::StarTet& t) {
  std::array<VertexId, 4> v;
  for (std::size_t k = 0; k < 4; ++k) v[k] = t.v[k] < 2 ? star.a() : star.vertices[t.v[k]].id;
  return v;
}

double sample_error_at(const EdgeStar& star, const StarLocation& at, Vec3 x, int label) {
  const double error = sample_error(interpolate(at.corners, seen_from(label, at.values, at.labels))(x), 1);
  return star.form == ZeroForm::embedded ? embedded_sample_error(error, at.tet->side == label) : error;
}

double side_at(const EdgeStar& star, const StarLocation& at, Vec3 x, int label) {
  if (star.form == ZeroForm::embedded) return at.tet->side == label ? 1 : -1;
  return interpolate(at.corners, seen_from(label, at.values, at.labels))(x);
}

} // namespace isoscope
