#version 330 core
// The ring between two radii, its edges covering pixels in part.

in vec2 place;

uniform float inner_radius;  // negative: a full disc
uniform float outer_radius;
uniform vec3 color;

out vec4 fragment;

void main() {
  float r = length(place);
  float pixel = max(fwidth(r), 1e-6);
  float cover = clamp((outer_radius - r) / pixel + 0.5, 0.0, 1.0) *
                clamp((r - inner_radius) / pixel + 0.5, 0.0, 1.0);
  if (cover <= 0.0) discard;
  fragment = vec4(color, cover);
}
