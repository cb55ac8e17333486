#version 330 core

in vec2 place;

uniform sampler2D image;

out vec4 fragment;

void main() {
  fragment = texture(image, place);
}
