// Tells files of points alone before they are read.
#pragma once

#include <filesystem>

namespace isoscope {

/// Whether a file lists points and no faces: by its name, or PLY and OFF by their header, OBJ by its lines. A
/// look, not a proof: what cannot be read or is none of these counts as something else.
bool holds_points_alone(const std::filesystem::path& file);

} // namespace isoscope
