#version 410 core
// The quiet vertical gradient behind everything.
in vec2 uv;
uniform vec3 top, bottom;
uniform vec2 rows; // the frame in the picture: heights of its lower and upper rim
uniform float opacity;
out vec4 colour;
void main() {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  colour = vec4(mix(bottom, top, smoothstep(0.0, 1.0, mix(rows.x, rows.y, uv.y))) + noise / 255.0, 1.0) * opacity;
}
