// Hand-made edge stars, and those of random Delaunay triangulations.
#pragma once

#include "mesh/complex.h"
#include "mesh/edge_star.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace isoscope::test {

/// A star from local numbers; tetrahedra are turned to be positive. Vertex i has the id 100 + i.
EdgeStar make_star(const std::vector<Vec3>& positions, const std::vector<std::array<std::uint16_t, 4>>& tets);
/// Embeds Z: a side for each tetrahedron, in their order, and 0 for every vertex but those listed, which get
/// the side of a tetrahedron they have.
void embed(EdgeStar& star, const std::vector<int>& sides, const std::vector<std::uint16_t>& not_on_z);

/// The edge (0, 0, ±0.3) within the octahedron of corners ±e_i: local numbers 2 to 5 are the ring, x0 x1 x2
/// x3, 6 the top over a = 0, 7 the bottom under b = 1. Tetrahedra: four of the ring, four at a, four at b,
/// each in the order of the ring's edges.
EdgeStar octahedron_star();
/// The same combinatorially with a ring of n vertices on the unit circle.
EdgeStar bipyramid_star(std::size_t n);

void transform(EdgeStar& star, double scale_x, double scale, Vec3 shift);

/// The star of an edge of a complex.
EdgeStar star_of(const Complex& complex, VertexId a, VertexId b);
/// Edges of a complex with no end at a corner of the box, ascending.
std::vector<std::pair<VertexId, VertexId>> inner_edges(const Complex& complex);
/// Stars of random Delaunay edges: `n` points, every `step`-th edge.
std::vector<EdgeStar> random_stars(std::size_t n, std::size_t step, std::uint64_t seed);

} // namespace isoscope::test
