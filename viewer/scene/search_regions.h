// What a search for a target left out: Ψ hatched, cells of the octree as boxes in the colour of their fate.
#pragma once

#include "questions/edge_xray.h"
#include "scene/line_batch.h"
#include "scene/meanings.h"
#include "scene/mesh_batch.h"
#include "scene/octree_fates.h"
#include "scene/view_frame.h"

namespace isoscope {

/// Of Ψ, faces and hatching.
constexpr std::uint32_t invalid_color = meaning_color::invalid;

/// Translucent faces, hatching, and a solid outline where Ψ meets the kernel or one of its own planes.
void add_invalid_regions(const EdgeXray& xray, const SceneSpace& space, LineBuilder& lines,
                         MeshBuilder& faces);
/// Boxes, a little shrunk so that neighbours are told apart.
void add_octree_cells(const CollapseAttempt& attempt, const SceneSpace& space, LineBuilder& lines);

} // namespace isoscope
