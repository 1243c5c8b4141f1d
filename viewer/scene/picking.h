// What lies under the mouse: rays against the elements that layers, filter and clip let see. No OpenGL.
#pragma once

#include "input/triangle_soup.h"
#include "questions/snapshot.h"
#include "scene/input_points.h"
#include "scene/renderer.h"
#include "scene/view_settings.h"
#include "tolerance/distance_grid.h"

namespace isoscope {

/// A position in a framebuffer, origin top left.
struct PickAt {
  double x = 0, y = 0;
  int width = 1, height = 1;
  double radius = 7; ///< pixels within which points are caught
};

/// What there is to be hit; any may be null.
struct PickScene {
  const StateSnapshot* state = nullptr;
  const TriangleSoup* input = nullptr;
  const DistanceGrid* grid = nullptr;
  const InputPoints* points = nullptr;
};

/// The hit number `depth_index` along the ray among the asked-for kinds. Number 0 is never behind an opaque
/// surface.
Pick pick_scene(const PickScene& scene, const Camera& camera, const ViewSettings& view, const PickAt& at,
                PickKinds kinds, int depth_index);

/// The nearest visible surface point under the position; at the target's depth where there is none.
Vec3 surface_point(const PickScene& scene, const Camera& camera, const ViewSettings& view, const PickAt& at);

/// The same in the 2D section: the nearest drawn sample, vertex or point of the input within the radius, else
/// the tetrahedron around the position. `points` may be null.
Pick pick_section_scene(const StateSnapshot& state, const InputPoints* points,
                        const Renderer::SectionView& section, const ViewSettings& view, const PickAt& at,
                        PickKinds kinds);

} // namespace isoscope
