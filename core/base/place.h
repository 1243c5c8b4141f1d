// A point in words.
#pragma once

#include "base/geometry.h"

#include <cstdio>
#include <string>

namespace isoscope {

/// Digits of places that are told, and of those that a proof names.
constexpr int place_digits = 6, proof_digits = 9;

/// "(x, y, z)" with so many significant digits, at most 17.
inline std::string place(Vec3 p, int digits) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.*g, %.*g, %.*g)", digits, p.x, digits, p.y, digits, p.z);
  return text;
}

} // namespace isoscope
