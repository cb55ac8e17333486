#version 330 core
// The mean of a pixel's samples.

uniform sampler2D samples;
uniform int count;     // samples across a pixel
uniform ivec2 origin;  // lower left corner of the viewport

out vec4 fragment;

void main() {
  ivec2 first = count * (ivec2(gl_FragCoord.xy) - origin);
  vec4 sum = vec4(0.0);
  for (int y = 0; y < count; ++y) {
    for (int x = 0; x < count; ++x) sum += texelFetch(samples, first + ivec2(x, y), 0);
  }
  fragment = sum / float(count * count);
}
