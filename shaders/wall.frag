#version 330 core

in vec3 eye_place;
in vec3 normal;

uniform vec3 color;
uniform bool perspective;

out vec4 fragment;

void main() {
  vec3 sight = perspective ? normalize(eye_place) : vec3(0.0, 0.0, -1.0);
  fragment = vec4(color * mix(0.7, 0.95, abs(dot(normalize(normal), sight))), 1.0);
}
