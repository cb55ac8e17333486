#version 330 core
// The slab's side, or glass: the more one looks along it, the more it hides.

in vec3 eye_place;
in vec3 normal;

uniform vec3 color;
uniform bool perspective;
uniform bool glass;

out vec4 fragment;

void main() {
  vec3 sight = perspective ? normalize(eye_place) : vec3(0.0, 0.0, -1.0);
  float facing = abs(dot(normalize(normal), sight));
  float grazing = 1.0 - facing;
  fragment = glass ? vec4(color, 0.05 + 0.2 * grazing * grazing * grazing)
                   : vec4(color * mix(0.7, 0.95, facing), 1.0);
}
