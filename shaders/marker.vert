#version 410 core
// Marks of fixed pixel size.
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 tint;
layout(location = 2) in uvec2 kind; // shape, diameter in interface pixels
out vec3 world;
flat out vec4 mark_tint;
flat out uint shape;
flat out float radius;
void main() {
  mark_tint = tint;
  shape = kind.x;
  radius = 0.5 * float(kind.y) * viewport.z;
  world = position;
  gl_Position = view_projection * vec4(position, 1.0);
  gl_Position.z -= 5e-4 * gl_Position.w;
  gl_PointSize = 2.0 * radius + 2.0;
}
