// Numbers kept in order, so that their distribution can be told.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace isoscope {

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
