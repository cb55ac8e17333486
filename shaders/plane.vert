#version 330 core
// A horizontal square that holds a ring around the z axis.

uniform mat4 eye_from_world;
uniform mat4 clip_from_eye;
uniform float height;
uniform float outer_radius;

out vec2 place;  // world x, y

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  place = corner * outer_radius * 1.1;  // room for the soft edge
  gl_Position = clip_from_eye * (eye_from_world * vec4(place, height, 1.0));
}
