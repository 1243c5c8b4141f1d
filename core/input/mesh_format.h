// Tells the format of a mesh file by its content, and by its name where the content does not tell.
#pragma once

#include "input/file_scanner.h"

namespace isoscope {

enum class MeshFormat { off, obj, ply, stl_ascii, stl_binary };

/// Looks at the head of a file and passes over a byte order mark. Fails on what is in none of the formats,
/// names it where it is something well known, and fails with unsupported on lists of points.
MeshFormat detect_format(FileScanner& in);

/// What is said to the owner of points.
extern const char* const points_remedy;

} // namespace isoscope
