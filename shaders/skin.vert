#version 330 core
// Surfaces whose vertices are lit already.

layout(location = 0) in vec3 place;  // world
layout(location = 1) in vec4 color;

uniform mat4 clip_from_world;

out vec4 shade;  // llvmpipe 22 makes a noperspective one NaN where it clips a triangle

void main() {
  shade = color;
  gl_Position = clip_from_world * vec4(place, 1.0);
}
