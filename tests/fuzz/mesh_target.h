// What the targets of the mesh readers share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isoscope::fuzz {

/// Reads the bytes as a mesh file with this extension (".off") and checks what comes of it.
bool accepts_mesh(std::string_view bytes, const char* extension);
/// What our own writer makes of a small mesh.
std::string written_mesh(const char* extension);
/// ASCII text as UTF-16 with its byte order mark, little-endian.
std::string in_utf16(std::string_view text);
/// Numbers and signs at which readers of numbers go wrong.
std::vector<std::string_view> number_words();

} // namespace isoscope::fuzz
