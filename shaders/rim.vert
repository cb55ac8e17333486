#version 330 core
// A horizontal circle around the z axis as a line of fixed width in pixels.

uniform mat4 clip_from_world;
uniform float radius;
uniform float height;
uniform int segments;
uniform vec2 half_viewport;  // pixels
uniform float half_width;    // pixels, the soft edge included

noperspective out float across;  // pixels from the middle of the line

void main() {
  float angle = 6.2831853 * float(gl_VertexID / 2) / float(segments);
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec4 place = clip_from_world * vec4(radius * cos(angle), radius * sin(angle), height, 1.0);
  vec4 ahead = clip_from_world * vec4(-sin(angle), cos(angle), 0.0, 0.0);
  vec2 direction = (ahead.xy * place.w - place.xy * ahead.w) * half_viewport;
  vec2 normal = vec2(-direction.y, direction.x) / max(length(direction), 1e-12);
  across = side * half_width;
  place.xy += side * half_width * normal / half_viewport * place.w;
  gl_Position = place;
}
