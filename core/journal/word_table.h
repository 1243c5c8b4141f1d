// What the tables of the vocabulary have in common: marks, what a number is, and that no row is missing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace isoscope {

/// The shapes of marks. The numbers are those of shaders/marker.frag; 8 more draws the outline alone.
enum class MarkerShape : std::uint8_t {
  ring,
  disc,
  cross,
  circle, ///< a thin ring
  square,
  diamond,
  triangle,
  plus,
  hollow_square = 12,
  hollow_diamond,
  hollow_triangle
};

/// What the value of an event is, and on which side of its limit it has to be.
enum class Measure : std::uint8_t {
  none,
  length,   ///< at most the limit; told in δ
  depth,    ///< a length above the limit
  error,    ///< ε, at most the limit
  alignment ///< of a normal or of f with the samples around it, above the limit
};
constexpr bool is_length(Measure measure) {
  return measure == Measure::length || measure == Measure::depth;
}

/// Whether a table has one row for each of so many values, in their order.
template <class Row, std::size_t n> constexpr bool is_complete(const std::array<Row, n>& table, int count) {
  for (std::size_t i = 0; i < n; ++i)
    if (static_cast<std::size_t>(table[i].value) != i || table[i].name.empty() || table[i].title.empty())
      return false;
  return n == static_cast<std::size_t>(count);
}
/// Whether a row has that name, or that title: what the screen calls a thing may be typed too.
template <class Row> constexpr bool is_called(const Row& row, std::string_view word) {
  return row.name == word || row.title == word;
}

} // namespace isoscope
