// How numbers are distributed: the middle of some, and any share of those that are kept in order.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace isoscope {

/// The upper of the two in the middle where their number is even. Of some.
inline double upper_median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class Quantiles {
 public:
  void add(double value) { sorted_.insert(std::upper_bound(sorted_.begin(), sorted_.end(), value), value); }
  void clear() { sorted_.clear(); }
  std::size_t size() const { return sorted_.size(); }
  /// The smallest of them that `part` of them do not exceed, part in (0, 1]; 0 when there is none.
  double at(double part) const {
    if (sorted_.empty()) return 0;
    const auto rank = static_cast<std::size_t>(std::ceil(part * static_cast<double>(sorted_.size())));
    return sorted_[std::clamp<std::size_t>(rank, 1, sorted_.size()) - 1];
  }

 private:
  std::vector<double> sorted_; ///< ascending
};

} // namespace isoscope
