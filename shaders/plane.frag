#version 330 core
// The floor in its light, with a grid, and the slab around it; edges cover pixels in part.

in vec2 place;

uniform float floor_radius;
uniform float outer_radius;
uniform float slab_depth;
uniform vec3 floor_color;
uniform vec3 slab_color;
uniform float spacing;    // of the grid; 0: none
uniform float line_width;  // samples
uniform float grid_shade;  // brightness of its lines
uniform bool lit;
uniform sampler2D light;  // over the square around the floor

uniform vec3 eye;
uniform vec3 backward;
uniform bool perspective;

out vec4 fragment;

void main() {
  float r = length(place);
  vec2 pixels = max(fwidth(place), 1e-6);
  float pixel = max(fwidth(r), 1e-6);
  float cover = clamp((outer_radius - r) / pixel + 0.5, 0.0, 1.0);
  if (cover <= 0.0) discard;  // it hides nothing
  vec3 color = floor_color;
  if (spacing > 0.0) {
    vec2 from_line = abs(fract(place / spacing + 0.5) - 0.5) * spacing;
    vec2 line = clamp(0.5 * line_width + 0.5 - from_line / pixels, 0.0, 1.0) *
                clamp(2.0 - 8.0 * line_width * pixels / spacing, 0.0, 1.0);
    color *= mix(1.0, grid_shade, max(line.x, line.y));
  }
  if (lit) color *= texture(light, place / (2.0 * floor_radius) + 0.5).r;
  color = mix(slab_color, color, clamp((floor_radius - r) / pixel + 0.5, 0.0, 1.0));
  // On the near side the slab's own side goes on below the edge, as far as it is seen from here.
  vec3 towards = perspective ? eye - vec3(place, 0.0) : backward;
  float below = slab_depth * dot(place / max(r, 1e-6), towards.xy) / max(abs(towards.z), 1e-3);
  float side = min(clamp(below / pixel, 0.0, 1.0), 1.0 - cover);
  color = (cover * color + side * 0.82 * slab_color) / (cover + side);
  cover += side;
  fragment = vec4(color, cover);
}
