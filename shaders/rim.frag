#version 330 core

in float across;
in float shown;

uniform vec3 color;
uniform float half_width;
uniform float opacity;

out vec4 fragment;

void main() {
  fragment = vec4(color, opacity * clamp(shown, 0.0, 1.0) * clamp(half_width - abs(across), 0.0, 1.0));
}
