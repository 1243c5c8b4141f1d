#version 410 core
// Samples as camera-facing sprites: a fixed size in pixels, smaller when far or when they would cover one another.
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in uint side; // 1 outer, 0 inner
uniform float size;      // pixels at the target's distance
uniform float spacing;   // scene units between neighbours, 0 unknown
uniform float smallest;  // pixels
flat out uint outer;
flat out float radius;
flat out float fog;
void main() {
  outer = side;
  float depth = eye.w > 0.5 ? view_depth(position) : forward.w;
  float near = clamp(forward.w / max(depth, 1e-20), 0.35, 2.5);
  float wanted = size * viewport.z * near;
  if (spacing > 0.0) wanted = min(wanted, 0.52 * spacing * pixels_per_unit(position));
  float diameter = max(wanted, smallest * viewport.z);
  radius = 0.5 * diameter;
  fog = clamp(1.0 - near, 0.0, 0.5);
  gl_Position = view_projection * vec4(position, 1.0);
  gl_PointSize = diameter + 1.5;
  // Samples lie within the surfaces that they belong to: lift them a little.
  gl_Position.z -= 2e-4 * gl_Position.w;
  if (clipped(position)) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
