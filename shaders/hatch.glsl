// Hatches of rooms, as wide on the screen at any distance; the same in every tile of a large picture.
const float hatch_period = 9.0; // interface pixels

// How much of the pixel a line of every period covers, `wide` interface pixels wide; `at` is counted in periods.
float hatch_line(float at, float wide) {
  float off = abs(fract(at) - 0.5) * hatch_period * viewport.z; // pixels
  return clamp(0.5 * wide * viewport.z - off + 0.5, 0.0, 1.0);
}

// How much ink of a hatch lies on a point of the scene.
float hatch_cover(int kind, vec3 p) {
  if (kind == 0) return 0.0;
  vec2 at = (view * vec4(p, 1.0)).xy * pixels_per_unit(p) / (viewport.z * hatch_period);
  vec2 turned = vec2(at.x - at.y, at.x + at.y) * 0.7071;
  if (kind == 1) return hatch_line(turned.x, 2.0);
  if (kind == 2) return hatch_line(turned.y, 2.0);
  if (kind == 3) return max(hatch_line(turned.x, 1.4), hatch_line(turned.y, 1.4));
  if (kind == 4) return hatch_line(at.y, 2.0);
  if (kind == 5) return hatch_line(at.x, 2.0);
  float off = length(fract(turned) - 0.5) * hatch_period * viewport.z;
  return clamp(2.0 * viewport.z - off + 0.5, 0.0, 1.0);
}
