// Ways to look at Ω: its boundaries and the haze between them, set together.
#pragma once

#include "scene/view_settings.h"

#include <array>
#include <string_view>

namespace isoscope {

struct VolumeLook {
  std::string_view name, title, tip;
  LayerSettings outer, inner;
  std::array<float, 3> haze; ///< at the outer boundary, at the input, at the inner boundary
};

/// The first is how Ω is drawn at first.
inline constexpr std::array<VolumeLook, 4> volume_looks{
    {{"shell", "Shell", "Both boundaries.", {true, 0.22f}, {true, 0.35f}, {0, 0, 0}},
     {"fog",
      "Fog",
      "A haze that is densest at the input, boundaries only hinted at.",
      {true, 0.05f},
      {true, 0.05f},
      {0.10f, 0.60f, 0.10f}},
     {"inner", "Inner", "The inner boundary alone.", {false, 0.22f}, {true, 0.85f}, {0, 0, 0}},
     {"thickness",
      "Thick",
      "An even haze: the darker, the more of Ω lies behind a pixel.",
      {true, 0.03f},
      {true, 0.03f},
      {0.25f, 0.25f, 0.25f}}}};

void apply(const VolumeLook& look, ViewSettings& view);
/// The look that a view has; null where somebody has set it otherwise.
const VolumeLook* look_of(const ViewSettings& view);

} // namespace isoscope
