// The colours of numbers on Z: even in brightness, readable without hue.
#pragma once

#include "questions/zero_map.h"

#include <glm/vec3.hpp>

namespace isoscope {

/// Viridis, from 0 to 1.
glm::vec3 map_color(float part);
/// Where a value lies between the ends of its map, in [0, 1]; ages by their logarithm, as most are young.
float map_part(const ZeroMap& map, float value);

} // namespace isoscope
