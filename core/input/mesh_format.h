// Tells the format of a file of triangles or points by its content, and by its name where the content does
// not tell.
#pragma once

#include "input/file_scanner.h"

#include <string_view>

namespace isoscope {

enum class MeshFormat { off, obj, ply, stl_ascii, stl_binary, xyz };

/// Looks at the head of a file and passes over a byte order mark. Fails on what is in none of the formats,
/// and names it where it is something well known.
MeshFormat detect_format(FileScanner& in);

/// Whether lists of points go under such a name, whatever stands above the numbers.
bool is_points_extension(std::string_view extension);

} // namespace isoscope
