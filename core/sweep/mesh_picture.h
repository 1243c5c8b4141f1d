// Thumbnails of meshes, shaded by a depth buffer of our own: a node of a cluster has no display, and the same
// mesh has the same bytes everywhere.
#pragma once

#include "input/triangle_soup.h"

#include <filesystem>
#include <span>
#include <string>

namespace isoscope::sweep {

struct PictureLook {
  unsigned width = 320, height = 240;
  bool result = true; ///< clay with its edges; an input that has no result is grey and smooth
};

/// A PNG on a transparent ground: an orthographic view of the whole, y upwards, from the right and above.
/// Empty where there is nothing to see.
std::string mesh_picture(std::span<const Vec3> points,
                         std::span<const std::array<std::uint32_t, 3>> triangles, const PictureLook& look);

/// Draws the mesh of a file into another one; takes that away where the mesh cannot be read, is very large,
/// or has no triangles: a run without a picture is none the worse.
void draw_result(const std::filesystem::path& mesh, bool result, const std::filesystem::path& picture);

} // namespace isoscope::sweep
