// The plane that shows what is selected.
#pragma once

#include "questions/edge_xray.h"
#include "scene/view_settings.h"

#include <optional>

namespace isoscope {

/// A plane through an element, and how large what it should show is.
struct SectionThrough {
  Vec3 point, normal; ///< the normal is of unit length
  Box3 shown;
};

/// Of an edge the plane through both its ends that shows most: with an X-ray the middle of its kernel, else
/// the normal of Z. Of a tetrahedron the plane along the gradient of f and its longest edge, so that Z is cut
/// across. Of what has no extent the plane across Z there. What is left to choose turns towards `eye`, a
/// direction. Nothing where the state has no such element. `xray` may be null.
std::optional<SectionThrough> section_through(const StateSnapshot& state, const Pick& pick,
                                              const EdgeXray* xray, Vec3 eye);

/// Where the handle of a clip's plane stands: at its point, or where that is outside of the model's box,
/// below the middle of it.
Vec3 clip_anchor(const ClipSettings& clip, const Box3& model);

} // namespace isoscope
