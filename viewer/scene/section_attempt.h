// The edge at hand in the 2D section: its kernel, Ψ, cells of the octree search, candidates, offenders and
// targets where the plane cuts them, as in Figures 7, 9, 11 and 12.
#pragma once

#include "journal/vocabulary.h"
#include "questions/target_study.h"
#include "scene/palette.h"
#include "scene/section_geometry.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isoscope {

/// Strengths, in [0, 1], tell how solid something is. Both drawings of the section, on
/// the screen and as a figure, are made from it.
struct AttemptSection {
  enum class Role : std::uint8_t { kernel, invalid, cell };
  /// A convex area with an outline.
  struct Area {
    Role role = Role::kernel;
    std::vector<PlanePoint> corners; ///< in order
    glm::vec3 color{0};
    float fill = 0, line = 1; ///< their strengths
    bool hatched = false;
  };
  struct Line {
    PlanePoint a, b;
    glm::vec3 color{0};
    float strength = 1, width = 1; ///< of the line in pixels of the interface
    bool dashed = false;
  };
  struct Mark {
    PlanePoint at;
    glm::vec3 color{0};
    MarkerShape shape = MarkerShape::disc;
    std::uint8_t diameter = 9;
    float strength = 1; ///< weaker where the point is far from the plane
  };
  std::vector<Area> areas;
  std::vector<Line> lines;
  std::vector<Mark> marks;

  std::size_t count(Role role) const;
  bool empty() const { return areas.empty() && lines.empty() && marks.empty(); }
};

/// What of the X-ray is drawn.
struct AttemptSectionOptions {
  bool invalid_regions = true, octree_cells = true;
  SceneColors colors;
};

/// `study` may be null.
AttemptSection attempt_section(const EdgeXray& xray, const TargetStudy* study, const SectionPlane& plane,
                               const AttemptSectionOptions& options);

/// Evenly spaced lines across a convex polygon; they run on from one polygon to the next.
std::vector<std::array<PlanePoint, 2>> hatch_lines(const std::vector<PlanePoint>& polygon, double spacing);

/// The polygon in which the plane cuts a convex polyhedron, corners in order; empty where it misses it.
std::vector<PlanePoint> cut_polyhedron(const KernelPolyhedron& shape, const SectionPlane& plane);
/// The same of a box.
std::vector<PlanePoint> cut_box(const Box3& box, const SectionPlane& plane);

} // namespace isoscope
