// The 2D section of a state by a plane: segments and points in the plane's coordinates.
#pragma once

#include "questions/snapshot.h"
#include "scene/renderer.h"
#include "tolerance/rim.h"

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
    int label = 0; ///< of its side
  };
  /// Where a curve of Z crosses the plane.
  struct Crossing {
    PlanePoint at;
    bool border = false; ///< of the border of Z, else of a curve where three sheets or more meet
  };
  std::vector<Segment> tetrahedra; ///< facets of T, each once
  std::vector<Cell> cells;         ///< of tetrahedra with a side; of rooms also their parts before
  std::vector<Segment> zero_set;
  std::vector<Segment> dropped; ///< what was cut off Z along the rim
  std::vector<Crossing> crossings;
  std::vector<Segment> gamma;       ///< ∂Γ
  std::vector<Sample> samples;      ///< within `sample_distance` of the plane
  std::vector<PlanePoint> over_rim; ///< boundary samples B as near to it
};

struct SectionOptions {
  bool box = false;           ///< also tetrahedra with a corner of the bounding box
  double sample_distance = 0; ///< half the thickness of the slab of samples
};

/// Intersects everything with the plane. Corners on the plane count as lying on its positive side.
SectionGeometry section_geometry(const StateSnapshot& state, const SectionPlane& plane,
                                 const SectionOptions& options);

/// Where the plane cuts a Z.
std::vector<SectionGeometry::Segment> zero_segments(const ZeroSet& zero, const SectionPlane& plane);

/// Where the border of an open input crosses the plane: open pieces, and those that Ω bridges.
struct RimCrossing {
  PlanePoint at;
  bool open = true;
};
std::vector<RimCrossing> rim_crossings(const Rim& rim, const SectionPlane& plane);

/// The alive tetrahedron whose section holds the point, invalid where none does.
TetId section_tet(const StateSnapshot& state, const SectionPlane& plane, PlanePoint at, bool box);

} // namespace isoscope
