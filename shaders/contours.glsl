// The face of a cut through Ω: cool towards the outer boundary, warm towards the inner one, with fine lines where d is a
// quarter, a half and three quarters of δ, the input's surface as a darker line, and both boundaries as rims.
// s: ±d over its largest value, the sign is the side; pixels: from d = 0 to the boundary. Straight alpha.
vec4 band(float s, float pixels, vec3 inner, vec3 outer) {
  float d = abs(s);
  vec3 rgb = mix(inner, outer, smoothstep(-0.12, 0.12, s));
  float fine = smoothstep(14.0, 30.0, pixels), from_line = abs(fract(4.0 * d + 0.5) - 0.5) * 0.25 * pixels;
  float line = fine * (1.0 - smoothstep(0.35, 1.15, from_line)) * step(0.125, d) * step(d, 0.875);
  float middle = float(is_signed) * smoothstep(3.0, 8.0, pixels) * (1.0 - smoothstep(0.5, 1.4, d * pixels));
  float rim = 1.0 - smoothstep(0.6, 1.9, (1.0 - d) * pixels);
  rgb *= mix(1.0, 0.72, line);
  rgb = mix(rgb, rgb * 0.45, max(0.8 * middle, 0.55 * rim));
  return vec4(rgb, mix(mix(0.78, 0.85, line), 0.97, max(rim, middle)));
}
