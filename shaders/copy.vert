#version 330 core
// A rectangle over the whole viewport, as two triangles.

out vec2 place;  // in a texture whose first row is the upper one

void main() {
  int corner = gl_VertexID < 3 ? gl_VertexID : (gl_VertexID - 1) % 4;  // 0 1 2, 2 3 0
  place = vec2(corner == 1 || corner == 2 ? 1.0 : 0.0, corner < 2 ? 0.0 : 1.0);
  gl_Position = vec4(2.0 * place.x - 1.0, 1.0 - 2.0 * place.y, 0.0, 1.0);
}
