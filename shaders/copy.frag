#version 410 core
// A picture as it is: how much of it is taken, blending says.
in vec2 uv;
uniform sampler2D picture;
out vec4 colour;
void main() { colour = texture(picture, uv); }
