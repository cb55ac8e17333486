#version 330 core
// A horizontal disc around the z axis with its soft edge, as one strip.

uniform mat4 clip_from_world;
uniform float height;
uniform float outer_radius;
uniform int segments;

out vec2 place;  // world x, y

void main() {
  float half_angle = 3.1415927 / float(segments);
  float angle = 2.0 * half_angle * float(gl_VertexID / 2);
  // Corners outside the outer circle, so that the sides between them do not cut it.
  float radius = (gl_VertexID & 1) == 0 ? 0.0 : 1.1 * outer_radius / cos(half_angle);
  place = radius * vec2(cos(angle), sin(angle));
  gl_Position = clip_from_world * vec4(place, height, 1.0);
}
