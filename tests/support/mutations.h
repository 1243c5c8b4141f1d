// Damage to bytes as disks, editors and broken exports do it, the same on every machine: for tests and
// fuzzing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace isoscope::test {

/// Draws that depend on the seed alone.
class Draws {
 public:
  explicit Draws(std::uint64_t seed);
  /// Uniform in [0, n); n at least 1.
  std::size_t below(std::size_t n);

 private:
  std::uint64_t state_;
};

/// One to three small edits: bytes, bits, digits and pieces changed, cut, repeated, or one of the `words` put
/// in.
std::string edited(std::string bytes, Draws& draws, std::span<const std::string_view> words);
/// One to four spots overwritten: with a byte, with 0xff or 0, with another part of the bytes, or with other
/// digits where digits are. The length stays.
std::string damaged(std::string bytes, Draws& draws);

} // namespace isoscope::test
