// Flat shading with edges of constant pixel width that fade where triangles get small.
#include "frame.glsl"
#include "hatch.glsl"
#include "light.glsl"
in vec3 world;
in vec3 corner;
flat in vec3 facet_normal;
flat in vec4 facet_tint;
flat in uint facet_edges;
uniform float opacity;
uniform vec4 edge_colour;   // a: strength
uniform float edge_width;   // pixels, 0 none
uniform float back_shade;   // brightness of the back face
uniform int walls;          // 1: what the two sides show stands below, not in the triangles
uniform vec3 front_tint, back_tint, front_ink, back_ink;
uniform int front_hatch, back_hatch;

// What a side of the fragment shows, without light.
vec3 side_colour(bool front) {
  if (walls == 0) return facet_tint.rgb;
  vec3 tint = front ? front_tint : back_tint, ink = front ? front_ink : back_ink;
  return mix(tint, ink, 0.8 * hatch_cover(front ? front_hatch : back_hatch, world));
}

float edge_cover(out float fade) {
  vec3 slope = vec3(length(vec2(dFdx(corner.x), dFdy(corner.x))), length(vec2(dFdx(corner.y), dFdy(corner.y))),
                    length(vec2(dFdx(corner.z), dFdy(corner.z))));
  slope = max(slope, vec3(1e-9));
  vec3 pixels = corner / slope;
  vec3 heights = 1.0 / slope;
  fade = smoothstep(1.5, 14.0, min(heights.x, min(heights.y, heights.z)));
  if ((facet_edges & 1u) == 0u) pixels.x = 1e9;
  if ((facet_edges & 2u) == 0u) pixels.y = 1e9;
  if ((facet_edges & 4u) == 0u) pixels.z = 1e9;
  float nearest = min(pixels.x, min(pixels.y, pixels.z));
  return 1.0 - smoothstep(0.5 * edge_width - 0.5, 0.5 * edge_width + 0.5, nearest);
}

// The fragment's colour and its opacity.
vec4 mesh_colour() {
  vec3 to_viewer = toward_viewer(world);
  vec3 n = normalize(facet_normal);
  bool front = dot(n, to_viewer) >= 0.0;
  vec3 base = lit(side_colour(front), front ? n : -n, to_viewer) * (front ? 1.0 : back_shade);
  float alpha = facet_tint.a * opacity;
  if (edge_width > 0.0) {
    float fade;
    float cover = edge_cover(fade) * edge_colour.a * mix(0.15, 1.0, fade);
    base = mix(base, edge_colour.rgb, cover);
    alpha = mix(alpha, max(alpha, opacity * edge_colour.a), cover);
  }
  return vec4(base, alpha);
}
