// All free vertices of a patch moved at once: where one after the other gets stuck, together they go on.
#pragma once

#include "improve/surface_patch.h"

namespace isoscope {

class InputSurface;

/// Moves the free vertices of a patch, those on a border excepted, by at most `rounds` steps, each of which
/// minimises the maximum of the linearised distances of all their facets (p-norms of growing p) and is kept
/// when the true energy falls. True where it has; the facets that moved are measured, and not proven.
/// Nothing is moved between rooms and inside T, where steps are bound to kernels.
bool relocate_jointly(const InputSurface& input, SurfacePatch& patch, int rounds);

} // namespace isoscope
