// How much memory operator new has given out: reading may not hold more than a multiple of what it reads.
#pragma once

#include <cstddef>

namespace isoscope::fuzz {

/// Bytes held now, and the most since restart_peak(). Both stay 0 under sanitizers, which have an operator
/// new of their own.
std::size_t bytes_held();
std::size_t peak_bytes();
void restart_peak();

} // namespace isoscope::fuzz
