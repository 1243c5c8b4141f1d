// Parts of lines of the shell about runs in tiles.
#pragma once

#include <filesystem>
#include <string>

namespace isoscope::test {

/// A model that is cut into many tiles within seconds.
inline const std::string model = "gallery:sphere --tolerance 4% --effort 1 --quiet --tile-memory 1MiB ";

inline std::string quoted(const std::filesystem::path& p) {
  return "'" + p.string() + "'";
}

} // namespace isoscope::test
