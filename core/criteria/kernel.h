// The visibility kernel K_T(ab) of an edge's one-ring: where the target of a collapse may lie so that T stays
// embedded (§2.4, Figures 7 and 11).
#pragma once

#include "base/geometry.h"
#include "mesh/edge_star.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// The points x with normal·x >= offset; the normal is of unit length.
struct HalfSpace {
  Vec3 normal;
  double offset = 0;
  double slack(Vec3 x) const { return dot(normal, x) - offset; }
};

/// An intersection of half-spaces, with the largest ball inside it.
struct Kernel {
  std::vector<HalfSpace> half_spaces; ///< one per facet of the one-ring's boundary that does not vanish
  /// The facets themselves, counter-clockwise seen from inside: what decides exactly.
  std::vector<Triangle3> facets;
  /// No ball of a relative radius above 1e-12 fits.
  bool empty = false;
  Vec3 center;                 ///< of the largest ball (Chebyshev); where it misses least when empty
  double inscribed_radius = 0; ///< of that ball; at most 0 when empty
  /// When empty: at most four half-spaces that already have no common point, and by how much they miss.
  std::vector<std::uint32_t> witness;
  double missing_slack = 0;

  /// Whether x lies strictly inside all facets. Exact.
  bool contains(Vec3 x) const;
  /// Adds a facet, counter-clockwise seen from inside, with its half-space.
  void add(const Triangle3& facet);
};

/// The kernel of a star; the same bits for the same star.
Kernel compute_kernel(const EdgeStar& star);

/// The largest ball inside an intersection of half-spaces.
struct InscribedBall {
  Vec3 center;
  double radius = 0;                ///< negative: by how much the half-spaces miss a common point
  std::vector<std::uint32_t> tight; ///< the half-spaces that hold the ball, at most four, ascending
};
/// `size` bounds the distance from `origin` to the points that matter: the ball is sought within a
/// tetrahedron that holds them.
InscribedBall inscribed_ball(std::span<const HalfSpace> half_spaces, Vec3 origin, double size);

/// The kernel as a polyhedron for display.
struct KernelPolyhedron {
  std::vector<Vec3> vertices;
  std::vector<std::vector<std::uint32_t>> faces; ///< counter-clockwise seen from outside
  std::vector<std::uint32_t> source;             ///< of each face: its half-space
  double volume = 0;
};
/// Without vertices when the kernel is empty.
KernelPolyhedron kernel_polyhedron(const Kernel& kernel);
/// The same for any half-spaces whose common points are no farther from `origin` than `size`.
KernelPolyhedron half_space_polyhedron(std::span<const HalfSpace> half_spaces, Vec3 origin, double size);

} // namespace isoscope
