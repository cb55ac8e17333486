#version 330 core
// Where the line of sight meets the sphere: its shade, and its true depth.

flat in vec3 sphere_centre;
flat in vec3 sphere_color;
flat in float sphere_radius;
in vec3 offset;

uniform mat4 clip_from_eye;
uniform bool perspective;
uniform float edge_shade;  // brightness where the surface turns away; 1 where it faces the eye

out vec4 fragment;

void main() {
  vec3 sight = vec3(0.0, 0.0, -1.0);
  vec3 nearest = offset;  // from the centre to the point of the line of sight nearest to it
  if (perspective) {
    // offset is perpendicular to the centre, so nothing large is subtracted from something large.
    vec3 place = sphere_centre + offset;
    float c2 = dot(sphere_centre, sphere_centre), o2 = dot(offset, offset);
    sight = normalize(place);
    nearest = (offset * c2 - sphere_centre * o2) / (c2 + o2);
  }
  float depth2 = sphere_radius * sphere_radius - dot(nearest, nearest);
  if (depth2 < 0.0) discard;
  float facing = sqrt(depth2) / sphere_radius;  // cosine between the surface's normal and the eye
  vec3 hit = sphere_centre + nearest - sqrt(depth2) * sight;

  vec2 clip = vec2(clip_from_eye[2][2] * hit.z + clip_from_eye[3][2],
                   clip_from_eye[2][3] * hit.z + clip_from_eye[3][3]);
  gl_FragDepth = 0.5 * clip.x / clip.y + 0.5;
  fragment = vec4(sphere_color * mix(edge_shade, 1.0, facing), 1.0);
}
