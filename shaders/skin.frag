#version 330 core

noperspective in vec4 shade;

out vec4 fragment;

void main() {
  fragment = shade;
}
