// What is to be seen in the view and what it means, as a list that the window and pictures draw alike.
#pragma once

#include "questions/edge_xray.h"
#include "questions/snapshot.h"
#include "scene/palette.h"

#include <memory>
#include <string>
#include <vector>

namespace isoscope {

struct LegendEntry {
  enum class Sign : std::uint8_t { surface, line, dashed, disc, ring, cross, diamond, cell, square };
  Sign sign = Sign::surface;
  glm::vec3 color{0};
  std::string words;
};

/// What the state alone does not tell of the scene.
struct LegendScene {
  bool rim = false, points = false;     ///< an open rim; a field of points
  std::shared_ptr<const EdgeXray> xray; ///< of the edge at hand, if any
  friend bool operator==(const LegendScene&, const LegendScene&) = default;
};

/// Of what the settings show and the state has, the most important first. `section`: of the 2D section.
std::vector<LegendEntry> scene_legend(const StateSnapshot& state, const ViewSettings& view, bool section,
                                      const LegendScene& scene);

} // namespace isoscope
