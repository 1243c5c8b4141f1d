// Linear between nine stops.
#include "scene/map_colors.h"

#include "scene/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {

glm::vec3 map_color(float part) {
  constexpr std::array<std::uint32_t, 9> stops{0x440154, 0x472D7B, 0x3B528B, 0x2C728E, 0x21918C,
                                               0x28AE80, 0x5EC962, 0xADDC30, 0xFDE725};
  const float at = std::clamp(part, 0.0f, 1.0f) * (stops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const float t = at - static_cast<float>(i);
  return (1 - t) * rgb(stops[i]) + t * rgb(stops[i + 1]);
}

float map_part(const ZeroMap& map, float value) {
  if (map.kind == ZeroMapKind::age) return std::log1p(std::max(value, 0.0f)) / std::log1p(map.high);
  return std::clamp((value - map.low) / (map.high - map.low), 0.0f, 1.0f);
}

} // namespace isoscope
