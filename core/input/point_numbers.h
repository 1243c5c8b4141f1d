// Gives points of equal coordinates one number.
#pragma once

#include "base/geometry.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

/// Numbers the points in the order in which they first occur, and keeps one of each in a list.
class PointNumbers {
 public:
  /// `points`, empty, outlives this; about so many are expected.
  explicit PointNumbers(std::vector<Vec3>& points, std::size_t expected = 0)
      : points_(&points), slots_(std::bit_ceil(2 * expected + 2), none) {
    points.reserve(expected);
  }

  /// -0 and 0 are one place; the first to come is kept as it is.
  std::uint32_t number(const Vec3& p) {
    std::size_t at = slot_of(p);
    if (slots_[at] != none) return slots_[at];
    if (2 * (points_->size() + 1) > slots_.size()) {
      grow();
      at = slot_of(p);
    }
    slots_[at] = static_cast<std::uint32_t>(points_->size());
    points_->push_back(p);
    return slots_[at];
  }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// Where p is, or is to be.
  std::size_t slot_of(const Vec3& p) const {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(p[i] + 0.0)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    std::size_t at = hash & (slots_.size() - 1);
    while (slots_[at] != none && (*points_)[slots_[at]] != p) at = (at + 1) & (slots_.size() - 1);
    return at;
  }

  void grow() {
    slots_.assign(2 * slots_.size(), none);
    for (std::uint32_t i = 0; i < points_->size(); ++i) slots_[slot_of((*points_)[i])] = i;
  }

  std::vector<Vec3>* points_;
  std::vector<std::uint32_t> slots_; ///< a power of two of them, at most half of them taken
};

} // namespace isoscope
