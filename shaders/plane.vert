#version 330 core
// A horizontal ring around the z axis, as one strip that holds it with its soft edges and covers
// little else: the middle of a ring costs no fragment.

uniform mat4 eye_from_world;
uniform mat4 clip_from_eye;
uniform float height;
uniform float inner_radius;  // negative: a full disc
uniform float outer_radius;
uniform int segments;

out vec2 place;  // world x, y

void main() {
  float half_angle = 3.1415927 / float(segments);
  float angle = 2.0 * half_angle * float(gl_VertexID / 2);
  // Corners outside the outer circle, so that the sides between them do not cut it.
  float radius = (gl_VertexID & 1) == 0 ? max(0.9 * inner_radius, 0.0)
                                        : 1.1 * outer_radius / cos(half_angle);
  place = radius * vec2(cos(angle), sin(angle));
  gl_Position = clip_from_eye * (eye_from_world * vec4(place, height, 1.0));
}
