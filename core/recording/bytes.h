// Compact bytes: integers of variable length, doubles bit for bit, the same on every machine.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace isoscope {

/// Small numbers of either sign become small numbers without one: 0, −1, 1, −2 ... become 0, 1, 2, 3 ...
constexpr std::uint64_t fold_sign(std::int64_t v) {
  return (static_cast<std::uint64_t>(v) << 1) ^ static_cast<std::uint64_t>(v >> 63);
}
constexpr std::int64_t unfold_sign(std::uint64_t v) {
  return static_cast<std::int64_t>(v >> 1) ^ -static_cast<std::int64_t>(v & 1);
}
/// The number that is so much more; beyond 64 bits it wraps, which only damaged bytes can ask for.
constexpr std::int64_t moved_by(std::int64_t v, std::int64_t difference) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(v) + static_cast<std::uint64_t>(difference));
}
/// Whether two doubles are the same bits: −0 is not 0, and a NaN is itself.
inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Appends to a string of bytes.
class ByteWriter {
 public:
  void byte(std::uint8_t b) { bytes_.push_back(static_cast<char>(b)); }
  /// Seven bits a byte, the lowest first.
  void number(std::uint64_t v) {
    for (; v >= 0x80; v >>= 7) byte(static_cast<std::uint8_t>(v | 0x80));
    byte(static_cast<std::uint8_t>(v));
  }
  void signed_number(std::int64_t v) { number(fold_sign(v)); }
  void real(double v) {
    auto bits = std::bit_cast<std::uint64_t>(v);
    for (int i = 0; i < 8; ++i, bits >>= 8) byte(static_cast<std::uint8_t>(bits & 0xff));
  }
  std::string_view bytes() const { return bytes_; }
  std::string take() { return std::move(bytes_); }
  void clear() { bytes_.clear(); }

 private:
  std::string bytes_;
};

/// Reads what ByteWriter wrote. Reading beyond the end gives zeros and marks the reader as failed.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
  bool failed() const { return failed_; }
  void fail() { failed_ = true; }
  /// Everything was read, and nothing beyond.
  bool exhausted() const { return !failed_ && at_ == bytes_.size(); }
  std::uint8_t byte() {
    if (at_ >= bytes_.size()) {
      failed_ = true;
      return 0;
    }
    return static_cast<std::uint8_t>(bytes_[at_++]);
  }
  std::uint64_t number() {
    std::uint64_t v = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const std::uint8_t b = byte();
      v |= static_cast<std::uint64_t>(b & 0x7f) << shift;
      if ((b & 0x80) == 0) return v;
    }
    failed_ = true;
    return 0;
  }
  std::int64_t signed_number() { return unfold_sign(number()); }
  double real() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= static_cast<std::uint64_t>(byte()) << (8 * i);
    return std::bit_cast<double>(bits);
  }
  /// A number of things that take at least `least` bytes each: never more than are left.
  std::size_t count(std::size_t least) {
    const std::uint64_t n = number();
    if (n > (bytes_.size() - at_) / least) failed_ = true;
    return failed_ ? 0 : static_cast<std::size_t>(n);
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

} // namespace isoscope
