#version 330 core
// A horizontal circle around the z axis as a line of fixed width in pixels.

uniform mat4 clip_from_world;
uniform mat4 clip_from_eye;
uniform vec3 eye;
uniform vec3 backward;
uniform bool perspective;
uniform float radius;
uniform float height;
uniform float side_height;  // of what the line is the foot of
uniform int segments;
uniform vec2 half_viewport;  // pixels
uniform float half_width;    // pixels, the soft edge included

out float across;  // pixels from the middle of the line
out float shown;   // share of a pixel of the side that is seen

void main() {
  float angle = 6.2831853 * float(gl_VertexID / 2) / float(segments);
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec3 world = vec3(radius * cos(angle), radius * sin(angle), height);
  vec4 place = clip_from_world * vec4(world, 1.0);
  // In front of the surfaces that meet there, which lie nearer than the line beside its middle.
  float pixel = place.w / (clip_from_eye[1][1] * half_viewport.y);
  vec3 towards = perspective ? normalize(eye - world) : backward;
  shown = side_height > 0.0 ? side_height * dot(world.xy / radius, towards.xy) / pixel : 1.0;
  vec4 nearer = clip_from_world * vec4(world + 4.0 * half_width * pixel * towards, 1.0);
  vec4 ahead = clip_from_world * vec4(-sin(angle), cos(angle), 0.0, 0.0);
  vec2 direction = (ahead.xy * place.w - place.xy * ahead.w) * half_viewport;
  vec2 normal = vec2(-direction.y, direction.x) / max(length(direction), 1e-12);
  across = side * half_width;
  place.xy += side * half_width * normal / half_viewport * place.w;
  place.z = nearer.z / nearer.w * place.w;
  gl_Position = place;
}
