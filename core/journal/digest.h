// A running digest of values: equal digests mean equal journals, deltas and states.
#pragma once

#include "journal/event.h"
#include "mesh/complex.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace isoscope {

/// FNV-1a, 64 bit, over values field by field: padding never enters.
class Digest {
 public:
  template <class T>
  requires std::is_integral_v<T> || std::is_enum_v<T>
  void add(T value) {
    auto bits = static_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < sizeof(T); ++i, bits >>= 8) add_byte(static_cast<std::uint8_t>(bits & 0xff));
  }
  template <class Tag> void add(Id<Tag> id) { add(id.value); }
  void add(double value);
  void add(Vec3 v);
  /// The length, then the bytes.
  void add(std::string_view text);
  void add(const Event& e);
  void add(const RepairSweep& s);
  void add(const Vertex& v);
  void add(const TetRecord& t);
  void add(const FacetRecord& f);
  void add(const Delta& d);
  void add(const Complex& c);
  template <class First, class Second, class... More>
  void add(const First& first, const Second& second, const More&... more) {
    add(first);
    add(second);
    (add(more), ...);
  }
  /// The elements of a list, without its length.
  template <class List> void each(const List& list) {
    for (const auto& element : list) add(element);
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
  void add_byte(std::uint8_t byte) { hash_ = (hash_ ^ byte) * 0x100000001b3u; }
};

/// Of the whole state, dead slots included.
std::uint64_t digest(const Complex& complex);
/// Of all that it changes, with the counts of slots before it.
std::uint64_t digest(const Delta& delta);
/// Sixteen hexadecimal digits.
std::string digest_text(std::uint64_t digest);

} // namespace isoscope
