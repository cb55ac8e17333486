#version 330 core
// A disc as a fan of triangles round the z axis.

uniform mat4 eye_from_world;
uniform mat4 clip_from_eye;
uniform float outer_radius;
uniform int segments;

void main() {
  float angle = 6.2831853 * float(gl_VertexID - 1) / float(segments);
  vec2 place = gl_VertexID == 0 ? vec2(0.0) : outer_radius * vec2(cos(angle), sin(angle));
  gl_Position = clip_from_eye * (eye_from_world * vec4(place, 0.0, 1.0));
}
