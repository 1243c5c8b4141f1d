// How much memory there is for this process.
#pragma once

#include <cstdint>

namespace isoscope {

/// Bytes of the machine's memory, or of what the process's control group may use where that is less; 0 where
/// neither can be found out.
std::uint64_t available_memory_bytes();

} // namespace isoscope
