// Where a point lies in the star of an edge, before and after a collapse, and what f says there.
#pragma once

#include "mesh/edge_star.h"

#include <array>

namespace isoscope {

/// A tetrahedron of a star with its corners at one of the two moments; null where none holds the point.
struct StarLocation {
  const EdgeStar::StarTet* tet = nullptr;
  std::array<Vec3, 4> corners;
  std::array<double, 4> values{};
  TetLabels labels{};
};

StarLocation locate_before(const EdgeStar& star, Vec3 x);
StarLocation locate_after(const EdgeStar& star, Vec3 target, Vec3 x);
/// F and labels of the corners after the collapse: both ends take those of the end that stays.
std::array<double, 4> values_after(const EdgeStar& star, const EdgeStar::StarTet& t);
TetLabels labels_after(const EdgeStar& star, const EdgeStar::StarTet& t);
/// The vertices of the corners after the collapse.
std::array<VertexId, 4> vertices_after(const EdgeStar& star, const EdgeStar::StarTet& t);
/// ε of a sample at a located point.
double sample_error_at(const EdgeStar& star, const StarLocation& at, Vec3 x, int label);
/// f at a located point as a side sees it, + on it; once Z is embedded ±1, as the tetrahedron is on it.
double side_at(const EdgeStar& star, const StarLocation& at, Vec3 x, int label);

} // namespace isoscope
