// Labels of vertices, and f as one of them sees it (§4.2): where there are several insides, each side has a
// function of its own.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace isoscope {

/// By corner of a tetrahedron; 0 on Z.
using TetLabels = std::array<std::int8_t, 4>;

/// +1 where F > 0, -room where F < 0, 0 where F = 0.
constexpr std::int8_t label_of(double value, std::int8_t room) {
  return static_cast<std::int8_t>(value > 0 ? 1 : value < 0 ? -room : 0);
}

/// The number of the inside that a label names; 1 for the outside.
constexpr std::int8_t room_of(int label) {
  return static_cast<std::int8_t>(label < 0 ? -label : 1);
}

/// The outside has the first place of a list by label, -1 the second, and so on.
constexpr std::size_t place_of(int label) {
  return label < 0 ? static_cast<std::size_t>(-label) : 0;
}

/// f_i at a vertex: |F| where its label is i, else -|F|. Of two labels it is ±F.
inline double seen_from(int label, double value, std::int8_t own) {
  return own == label ? std::abs(value) : -std::abs(value);
}
inline std::array<double, 4> seen_from(int label, const std::array<double, 4>& values,
                                       const TetLabels& labels) {
  std::array<double, 4> f{};
  for (std::size_t k = 0; k < 4; ++k) f[k] = seen_from(label, values[k], labels[k]);
  return f;
}

/// How many labels the corners have, but for 0.
constexpr int label_count(const TetLabels& labels) {
  int count = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    bool fresh = labels[k] != 0;
    for (std::size_t j = 0; j < k; ++j) fresh &= labels[j] != labels[k];
    count += fresh ? 1 : 0;
  }
  return count;
}

/// Whether Z passes through a tetrahedron, or touches it where F = 0 at a corner.
constexpr bool carries_zero_set(const TetLabels& labels) {
  return label_count(labels) > 1 || std::find(labels.begin(), labels.end(), 0) != labels.end();
}

/// The largest label of the corners and the smallest one, but for 0: the two where there are two. Z is seen
/// from the larger one.
struct LabelPair {
  std::int8_t front = 0, back = 0;
  friend constexpr bool operator==(const LabelPair&, const LabelPair&) = default;
};
constexpr LabelPair outer_labels(const TetLabels& labels) {
  LabelPair pair;
  for (const std::int8_t label : labels) {
    if (label == 0) continue;
    pair.front = pair.front == 0 ? label : std::max(pair.front, label);
    pair.back = pair.back == 0 ? label : std::min(pair.back, label);
  }
  return pair;
}
/// Of at most two labels: f as the larger one sees it; Z is where it is 0.
inline std::array<double, 4> seen_from_front(const std::array<double, 4>& values, const TetLabels& labels) {
  return seen_from(outer_labels(labels).front, values, labels);
}

} // namespace isoscope
