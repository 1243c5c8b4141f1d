// Files without a name: gone when they are closed, or the program is killed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace isoscope {

/// Makes one in a folder, to be read and written; -1 with errno where it cannot be made.
int open_nameless(const std::filesystem::path& folder);
/// Writes all of it there; 0, or what errno was.
int write_all(int file, const void* data, std::size_t bytes, std::uint64_t offset);

} // namespace isoscope
