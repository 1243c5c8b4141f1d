// The scene's colours: meaning is the same in every theme, grounds and lines follow it.
#pragma once

#include "scene/view_settings.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

namespace isoscope {

/// sRGB, each in [0, 1].
struct SceneColors {
  glm::vec3 ground_top, ground_bottom;
  glm::vec3 zero_set, zero_set_edge;
  glm::vec3 other_zero; ///< Z of another run
  glm::vec3 good, bad, warning, misoriented, gamma, outer, inner, selection, accent;
  glm::vec3 input, input_edge;
  glm::vec3 dropped; ///< points that no site stands for
  glm::vec3 rim;     ///< the open rim of the input, and the samples over it
  glm::vec3 tetrahedron, tetrahedron_edge;
  glm::vec3 outside_cells, inside_cells; ///< tetrahedra by side: not Ω's colours, as they are not Ω
  glm::vec3 section_line;                ///< T in the 2D section
  glm::vec3 section_zero;                ///< Z in the 2D section
};

SceneColors scene_colors(ThemeKind theme);

/// Lines over a ground that tell rooms apart where colours do not. The numbers are those of
/// shaders/hatch.glsl.
enum class Hatch : std::uint8_t { none, rising, falling, crossed, level, upright, dots };

/// How a side is drawn where there are several insides.
struct RoomStyle {
  glm::vec3 color;
  Hatch hatch = Hatch::none;
};
/// Of a label: the outside as Ω's outer boundary and plain, the first inside as its inner boundary; colours
/// and hatches recur after different counts, so that together they tell many rooms apart.
RoomStyle room_style(int label);
/// Of tetrahedra on a side of Z; where there are several insides that of their room.
glm::vec3 side_color(int label, bool rooms, const SceneColors& colors);

/// "#rrggbb" given as 0xrrggbb.
constexpr glm::vec3 rgb(std::uint32_t hex) {
  return {static_cast<float>((hex >> 16) & 255u) / 255.0f, static_cast<float>((hex >> 8) & 255u) / 255.0f,
          static_cast<float>(hex & 255u) / 255.0f};
}

} // namespace isoscope
