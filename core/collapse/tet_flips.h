// Flips of T that leave Z as it is: they make room for a collapse that T stands in the way of.
#pragma once

#include "collapse/tet_patch.h"
#include "journal/refusal.h"

namespace isoscope {

/// Takes an edge that is not on Z out of T: the tetrahedra around it give way to others over a triangulation
/// of their ring, all positively oriented (exact). False, and nothing changed, where there is none or the
/// edge is on Z or on the hull. Every tetrahedron at the edge must be in the patch.
bool remove_edge(TetPatch& patch, std::uint32_t p, std::uint32_t q);
/// The same for a triangle between two tetrahedra, which three around a new edge replace.
bool remove_triangle(TetPatch& patch, const std::array<std::uint32_t, 3>& triangle);

/// What T has against merging the ends of an edge of Z: link conditions, kernel. Where it can be helped,
/// edges and triangles at the ends are removed; `kernel` is that of the star as it is then, filled when
/// nothing is left against it. The same outcome for the same star. All tetrahedra at a and b must be in the
/// patch.
Refusal make_collapsible(TetPatch& patch, VertexId a, VertexId b, Kernel& kernel);

} // namespace isoscope
