#version 330 core
// Where the line of sight meets the ellipsoid: its light, its true depth, and how much of the pixel it
// covers.

in vec3 start, offset_seen;
flat in vec3 sight, sight_seen, centre_seen;
flat in mat3 from_world;
flat in vec3 own_color;
flat in vec3 sky[2], key[2];
flat in float body_radius;
flat in float least_step;

uniform bool perspective;
uniform bool soft;  // edges cover pixels in part
uniform vec3 lamp;
uniform vec3 strengths;  // of lamp, sky and floor
uniform vec3 limits;     // the light that counts as 1; the least; of the sky's at the foot
uniform float gamma;

out vec4 fragment;

// Of the sides along and against the axes, as much as each faces this way.
float share(vec3 left[2], vec3 normal) {
  return dot(normal * normal, mix(left[1], left[0], step(0.0, normal)));
}

// As view::Light::at.
float brightness(vec3 normal, float z) {
  float open = share(sky, normal);
  float height = clamp(z / body_radius, 0.0, 1.0);
  vec2 up = vec2(0.5) + vec2(0.5, -0.5) * normal.z;
  float light =
      strengths.x * max(dot(normal, lamp), 0.0) * share(key, normal) * sqrt(open) +
      open * (strengths.y * up.x * mix(limits.z, 1.0, height) + strengths.z * up.y * height);
  return pow(clamp(light / limits.x, limits.y, 1.0), 1.0 / gamma);
}

void main() {
  // The line's place nearest to the centre lies `ahead` on it, and where it meets the surface `back`
  // from there.
  float spread = perspective ? 1.0 : 0.0;
  vec3 line = sight + spread * start;
  float line2 = dot(line, line), ahead = -dot(start, line) / line2;
  vec3 nearest = start + ahead * line;
  float r = length(nearest);
  float outside = (r - 1.0) / max(length(vec2(dFdx(r), dFdy(r))), least_step);  // pixels
  float cover = soft ? 0.5 - outside : step(outside, 0.0);
  if (cover <= 0.0) discard;
  float back = sqrt(max(1.0 - r * r, 0.0) / line2);
  vec3 hit = nearest / max(r, 1.0) - back * line;
  vec3 seen = centre_seen + offset_seen + (ahead - back) * (sight_seen + spread * offset_seen);
  gl_FragDepth = 0.5 * seen.x / seen.y + 0.5;
  fragment = vec4(own_color * brightness(normalize(from_world * hit), seen.z), min(cover, 1.0));
}
