#version 410 core
// Flat triangles, three vertices each, with marked edges.
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in uint edges; // bit i: the edge opposite corner i is drawn
layout(location = 3) in vec4 tint;
out vec3 world;
out vec3 corner;
flat out vec3 facet_normal;
flat out vec4 facet_tint;
flat out uint facet_edges;
void main() {
  int index = gl_VertexID % 3;
  corner = vec3(index == 0, index == 1, index == 2);
  world = position;
  facet_normal = normal;
  facet_tint = tint;
  facet_edges = edges;
  gl_Position = view_projection * vec4(position, 1.0);
}
