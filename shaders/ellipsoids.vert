#version 330 core
// A quad around each ellipsoid, just wide enough to hold its outline and a pixel around it.

layout(location = 0) in vec3 centre;    // per ellipsoid, world
layout(location = 1) in vec3 diagonal;  // of its matrix, which maps a unit sphere to it
layout(location = 2) in vec3 beside;    // xy, xz, yz
layout(location = 3) in vec4 color;
layout(location = 4) in vec3 sky_along;  // light that neighbours leave on the sides along the axes
layout(location = 5) in vec3 sky_against;
layout(location = 6) in vec3 key_along;
layout(location = 7) in vec3 key_against;
layout(location = 8) in float radius;  // of the body

uniform mat4 clip_from_world;
uniform vec3 eye;       // world
uniform vec3 backward;  // towards the eye, without perspective
uniform bool perspective;
uniform float pixel;  // edge of a pixel, world units; in perspective at distance 1

// The line of sight through the quad's place: in the space where the ellipsoid is a unit sphere, and
// as it is seen: (depth, w, height over the floor) of the picture.
out vec3 start, offset_seen;      // from the centre to the quad's place
flat out vec3 sight, sight_seen;  // the line's direction at the centre
flat out vec3 centre_seen;
flat out mat3 from_world;
flat out vec3 own_color;
flat out vec3 sky[2], key[2];
flat out float body_radius;
flat out float least_step;  // of the distance from the unit sphere's centre, a pixel on

vec3 seen(vec4 world) {
  return vec3((clip_from_world * world).zw, world.z);
}

void main() {
  mat3 shape = mat3(diagonal.x, beside.x, beside.y,  //
                    beside.x, diagonal.y, beside.z,  //
                    beside.y, beside.z, diagonal.z);
  from_world = inverse(shape);
  own_color = color.rgb;
  sky = vec3[2](sky_along, sky_against);
  key = vec3[2](key_along, key_against);
  body_radius = radius;
  vec3 towards = perspective ? eye - centre : backward;
  sight = -(from_world * towards);
  sight_seen = -seen(vec4(towards, 0.0));
  centre_seen = seen(vec4(centre, 1.0));
  float away = length(towards);
  towards /= away;
  float pixel_edge = pixel * (perspective ? away : 1.0);
  vec3 helper = abs(towards.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
  vec3 across = normalize(cross(helper, towards)), along = cross(towards, across);
  vec2 size = vec2(length(shape * across), length(shape * along));
  // No axis is longer than the sides of the box around the ellipsoid.
  least_step = pixel_edge * inversesqrt(dot(size, size) + dot(shape * towards, shape * towards));
  if (perspective) {
    // Lines of sight that touch the ellipsoid meet the quad's plane further out.
    float nearest = length(shape * towards) / away;
    size *= inversesqrt(max(1.0 - nearest * nearest, 0.01));
  }
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  corner *= size + pixel_edge;
  vec3 offset = corner.x * across + corner.y * along;
  start = from_world * offset;
  offset_seen = seen(vec4(offset, 0.0));
  gl_Position = clip_from_world * vec4(centre + offset, 1.0);
}
