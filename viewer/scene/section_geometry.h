// The 2D section of a state by a plane: segments and points in the plane's coordinates.
#pragma once

#include "questions/snapshot.h"
#include "scene/renderer.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isoscope {

/// A point of the plane; u and v relative to its origin, scene units.
struct PlanePoint {
  double u = 0, v = 0;
};

/// A plane with its coordinates.
struct SectionPlane {
  Vec3 origin;
  PlaneAxes axes;
  PlanePoint project(Vec3 p) const { return {dot(p - origin, axes.u), dot(p - origin, axes.v)}; }
  double height(Vec3 p) const { return dot(p - origin, axes.normal); }
  Vec3 lift(PlanePoint p) const { return origin + p.u * axes.u + p.v * axes.v; }
};

struct SectionGeometry {
  struct Segment {
    PlanePoint a, b;
  };
  struct Sample {
    PlanePoint at;
    SampleId id;
    bool bad = false, outer = true;
  };
  /// Where the plane cuts a tetrahedron: a triangle or quad, corners in order.
  struct Cell {
    std::array<PlanePoint, 4> corners;
    std::size_t count = 0;
    bool negative = false; ///< its side
  };
  std::vector<Segment> tetrahedra; ///< facets of T, each once
  std::vector<Cell> cells;         ///< of tetrahedra with a side
  std::vector<Segment> zero_set;
  std::vector<Segment> gamma;  ///< ∂Γ
  std::vector<Sample> samples; ///< within `sample_distance` of the plane
};

struct SectionOptions {
  bool box = false;           ///< also tetrahedra with a corner of the bounding box
  double sample_distance = 0; ///< half the thickness of the slab of samples
};

/// Intersects everything with the plane. Corners on the plane count as lying on its positive side.
SectionGeometry section_geometry(const StateSnapshot& state, const SectionPlane& plane,
                                 const SectionOptions& options);

/// The alive tetrahedron whose section holds the point, invalid where none does.
TetId section_tet(const StateSnapshot& state, const SectionPlane& plane, PlanePoint at, bool box);

} // namespace isoscope
