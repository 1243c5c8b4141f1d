// Turns a list into a set.
#pragma once

#include <algorithm>
#include <vector>

namespace isoscope {

/// Sorts the values and drops those that occur again.
template <class T> void sort_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace isoscope
