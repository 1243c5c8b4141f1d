#version 410 core
// Puts translucent cells and Ω over the opaque picture.
#include "frame.glsl"
#include "blend.glsl"
in vec2 uv;
uniform sampler2D opaque_colour, cell_sum, cell_cover, volume_colour, volume_depth;
uniform int with_cells, with_volume;
out vec4 colour;
void main() {
  vec4 sum = vec4(0.0);
  float clear_part = 1.0;
  if (with_cells == 1) {
    sum = texture(cell_sum, uv);
    clear_part = texture(cell_cover, uv).r;
  }
  if (with_volume == 1) {
    vec4 volume = texture(volume_colour, uv);
    if (volume.a > 0.0) {
      float weight = blend_weight(texture(volume_depth, uv).r / 1.0, volume.a);
      sum += volume * weight;
      clear_part *= 1.0 - volume.a;
    }
  }
  vec4 behind = texture(opaque_colour, uv);
  vec3 translucent = sum.a > 1e-6 ? sum.rgb / sum.a : vec3(0.0);
  colour = vec4(translucent * (1.0 - clear_part) + behind.rgb * clear_part, (1.0 - clear_part) + behind.a * clear_part);
}
