#version 330 core
// A ring one pixel wide around the outline that fades outwards. Spheres in front hide it.

flat in vec3 sphere_color;
flat in float outline;
flat in float pixel_edge;
in vec3 offset;

uniform float edge_shade;

out vec4 fragment;

void main() {
  float cover = 1.0 - (length(offset) - outline) / pixel_edge;
  fragment = vec4(sphere_color * edge_shade, clamp(cover, 0.0, 1.0));
}
