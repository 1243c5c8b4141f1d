// The plane and the camera of the 2D section.
#pragma once

#include "scene/input_points.h"
#include "scene/section_geometry.h"

namespace isoscope {

/// The plane that a section view shows: the clip's, whatever its shape.
SectionPlane section_plane(const ClipSettings& clip);
/// The orthographic camera that looks at the plane from its normal's side.
Camera section_camera(const Renderer::SectionView& section, const ClipSettings& clip);
/// Half the thickness of the slab whose samples are drawn, scene units: half of σ.
double section_sample_distance(const StateSnapshot& state);
/// The same for points of the input: as far as their neighbours are.
double section_point_distance(const InputPoints& points);

} // namespace isoscope
