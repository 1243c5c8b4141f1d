// What every program of the 3D view knows of the frame. Positions are relative to the scene's origin.
layout(std140) uniform Frame {
  mat4 view_projection;
  mat4 inverse_view_projection;
  mat4 view;
  vec4 eye;         // xyz; w: 1 perspective, 0 orthographic
  vec4 forward;     // xyz unit; w: distance to the target
  vec4 viewport;    // width, height, pixels of one interface unit, pixels of one scene unit at depth 1 (or anywhere)
  vec4 clip_point;  // xyz; w: radius or half thickness
  vec4 clip_normal; // xyz unit; w: -1 when flipped, else 1
  vec4 clip_shape;  // x: 0 none, 1 plane, 2 slab, 3 ball; y: 1 when fragments are cut
};

float view_depth(vec3 p) { return dot(p - eye.xyz, forward.xyz); }

// Pixels that one scene unit covers at p.
float pixels_per_unit(vec3 p) { return eye.w > 0.5 ? viewport.w / max(view_depth(p), 1e-20) : viewport.w; }

// Unit vector from p to the viewer.
vec3 toward_viewer(vec3 p) { return eye.w > 0.5 ? normalize(eye.xyz - p) : -forward.xyz; }

// Distance to the clip's surface, positive where kept.
float kept_distance(vec3 p) {
  vec3 offset = p - clip_point.xyz;
  float height = dot(offset, clip_normal.xyz);
  float kept = 1.0;
  if (clip_shape.x > 2.5) kept = clip_point.w - length(offset);
  else if (clip_shape.x > 1.5) kept = clip_point.w - abs(height);
  else if (clip_shape.x > 0.5) kept = -height;
  return clip_shape.x > 0.5 ? kept * clip_normal.w : kept;
}

bool clipped(vec3 p) { return clip_shape.y > 0.5 && kept_distance(p) < 0.0; }
