#version 330 core
// A quad around each sphere, just wide enough to hold its outline and `margin` pixels around it.

layout(location = 0) in vec3 centre;  // per sphere, world
layout(location = 1) in vec4 color;   // per sphere, lit

uniform mat4 eye_from_world;
uniform mat4 clip_from_eye;
uniform float radius;
uniform bool perspective;
uniform float pixel;   // edge of a pixel, world units; in perspective at distance 1
uniform float shrink;  // pixels that the radius is less
uniform float margin;

flat out vec3 sphere_centre;  // eye space
flat out vec3 sphere_color;
flat out float sphere_radius;
flat out float outline;     // its radius on the quad's plane
flat out float pixel_edge;  // there
out vec3 offset;            // from the centre, on the quad's plane

void main() {
  vec3 c = (eye_from_world * vec4(centre, 1.0)).xyz;
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  sphere_centre = c;
  sphere_color = color.rgb;
  pixel_edge = pixel * (perspective ? -c.z : 1.0);
  sphere_radius = max(radius - shrink * pixel_edge, 0.0);
  vec3 across = vec3(1.0, 0.0, 0.0), along = vec3(0.0, 1.0, 0.0);
  outline = sphere_radius;
  if (perspective) {
    // The quad faces the eye; there the cone of sight lines that touch the sphere is this wide.
    float distance2 = dot(c, c);
    float outside = distance2 - sphere_radius * sphere_radius;
    if (outside <= 0.0) {  // the eye is inside the sphere
      offset = vec3(0.0);
      gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
      return;
    }
    vec3 towards = c * inversesqrt(distance2);
    vec3 helper = abs(towards.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    across = normalize(cross(helper, towards));
    along = cross(towards, across);
    outline *= sqrt(distance2 / outside);
  }
  offset = (outline + margin * pixel_edge) * (corner.x * across + corner.y * along);
  gl_Position = clip_from_eye * vec4(c + offset, 1.0);
}
