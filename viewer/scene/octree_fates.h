// How the fates of cells of the octree search are shown.
#pragma once

#include "collapse/collapse_attempt.h"

#include <cstdint>
#include <string_view>

namespace isoscope {

struct FateStyle {
  std::uint32_t color = 0; ///< 0xRRGGBB
  std::string_view title, help;
};
const FateStyle& fate_style(OctreeCell::Fate fate);
constexpr std::size_t fate_count = 5;
/// Most cells have such a fate; the others tell more.
constexpr bool is_faint(OctreeCell::Fate fate) {
  return fate == OctreeCell::Fate::outside_kernel || fate == OctreeCell::Fate::costlier;
}

} // namespace isoscope
