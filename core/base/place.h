// A point in words.
#pragma once

#include "base/geometry.h"

#include <cstdio>
#include <string>

namespace isoscope {

/// "(x, y, z)" with so many significant digits, at most 17.
inline std::string place(Vec3 p, int digits) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.*g, %.*g, %.*g)", digits, p.x, digits, p.y, digits, p.z);
  return text;
}

} // namespace isoscope
