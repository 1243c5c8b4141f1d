// How much memory there is for this process.
#pragma once

#include <cstddef>
#include <cstdint>

namespace isoscope {

/// Bytes of the machine's memory, or of what the process's control group may use where that is less; 0 where
/// neither can be found out.
std::uint64_t available_memory_bytes();
/// The most that this process has had in memory so far, bytes.
std::size_t peak_memory_bytes();

} // namespace isoscope
