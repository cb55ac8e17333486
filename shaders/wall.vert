#version 330 core
// An upright cylinder around the z axis, as one strip.

uniform mat4 eye_from_world;
uniform mat4 clip_from_eye;
uniform float radius;
uniform float bottom;
uniform float top;
uniform int segments;

out vec3 eye_place;
out vec3 normal;  // eye space

void main() {
  float angle = 6.2831853 * float(gl_VertexID / 2) / float(segments);
  vec3 outwards = vec3(cos(angle), sin(angle), 0.0);
  vec4 place = vec4(radius * outwards.xy, (gl_VertexID & 1) == 0 ? bottom : top, 1.0);
  normal = mat3(eye_from_world) * outwards;
  eye_place = (eye_from_world * place).xyz;
  gl_Position = clip_from_eye * vec4(eye_place, 1.0);
}
