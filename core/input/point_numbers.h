// Gives points of equal coordinates one number.
#pragma once

#include "base/geometry.h"

#include <bit>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace isoscope {

/// Numbers the points in the order in which they first occur, and keeps one of each in a list.
class PointNumbers {
 public:
  /// `points`, empty, outlives this.
  explicit PointNumbers(std::vector<Vec3>& points) : points_(&points) {}
  std::uint32_t number(Vec3 p) {
    for (int i = 0; i < 3; ++i) p[i] += 0.0; // -0 and 0 are one place
    const auto [place, fresh] = numbers_.try_emplace(p, static_cast<std::uint32_t>(points_->size()));
    if (fresh) points_->push_back(p);
    return place->second;
  }

 private:
  struct Hash {
    std::size_t operator()(const Vec3& p) const {
      std::uint64_t h = 0;
      for (int i = 0; i < 3; ++i) {
        h = (h ^ std::bit_cast<std::uint64_t>(p[i])) * 0x9e3779b97f4a7c15u;
        h ^= h >> 29;
      }
      return static_cast<std::size_t>(h);
    }
  };

  std::vector<Vec3>* points_;
  std::unordered_map<Vec3, std::uint32_t, Hash> numbers_;
};

} // namespace isoscope
