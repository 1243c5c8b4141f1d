// The triangles of a file one after the other, of files that are larger than memory.
#pragma once

#include "base/geometry.h"
#include "base/run_control.h"
#include "base/status.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>

namespace isoscope {

/// Where vertices and faces are kept meanwhile, and how much of them may be in memory.
struct StreamRoom {
  std::filesystem::path folder;
  std::size_t most_bytes = 0;
};

/// What a file had.
struct StreamedFile {
  std::uint64_t points = 0; ///< that it lists; of STL, which lists none, 0
  std::uint64_t triangles = 0;
};

/// Reads OFF, OBJ, PLY or STL, by content where the name does not tell, and gives each triangle in the order
/// of the file; those that name a vertex twice are left out, as read_mesh() does. Fails as that, and with
/// unsupported on faces of more than three corners and on what has no faces, with io where the room is full.
Result<StreamedFile> stream_triangles(const std::filesystem::path& file, const StreamRoom& room,
                                      const std::function<void(const Triangle3&)>& take,
                                      const RunControl& control);

} // namespace isoscope
