#version 410 core
// Smooth-edged lines, solid or dashed.
#include "frame.glsl"
noperspective in float across;
noperspective in float along;
in vec3 world;
flat in float half_width;
flat in uint dashed;
flat in vec4 line_tint;
uniform float opacity;
layout(location = 0) out vec4 colour;
void main() {
  if (clipped(world)) discard;
  float alpha = line_tint.a * opacity * clamp(half_width + 0.5 - abs(across), 0.0, 1.0) * min(1.0, 2.0 * half_width);
  if (dashed != 0u) {
    float period = 9.0 * viewport.z, at = mod(along, period);
    alpha *= clamp(0.5 * period + 0.5 - abs(at - 0.5 * period) - 0.22 * period, 0.0, 1.0);
  }
  if (alpha < 0.02) discard;
  colour = vec4(line_tint.rgb * alpha, alpha);
}
