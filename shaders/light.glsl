// Hemisphere light from above plus one key light fixed to the camera.
vec3 lit(vec3 colour, vec3 normal, vec3 to_viewer) {
  vec3 n = mat3(view) * normal;
  float sky = 0.5 + 0.5 * normal.y;
  float key = max(dot(n, normalize(vec3(-0.40, 0.55, 0.85))), 0.0);
  vec3 halfway = normalize(normalize(vec3(-0.40, 0.55, 0.85)) + mat3(view) * to_viewer);
  float gloss = pow(max(dot(n, halfway), 0.0), 40.0);
  vec3 ambient = mix(vec3(0.30, 0.29, 0.28), vec3(0.44, 0.46, 0.50), sky);
  return colour * (ambient + 0.60 * key) + 0.06 * gloss;
}
