// Puts lists and small arrays in order.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace isoscope {

/// Sorts the values and drops those that occur again.
template <class T> void sort_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// The same values, ascending.
template <class T, std::size_t n> std::array<T, n> sorted(std::array<T, n> values) {
  std::sort(values.begin(), values.end());
  return values;
}

} // namespace isoscope
