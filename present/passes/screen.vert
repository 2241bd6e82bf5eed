// One triangle that covers the picture, without buffers. clip: the point in clip coordinates, (-1, -1) at the
// lower left corner.
out vec2 clip;

void main() {
  clip = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1);
  gl_Position = vec4(clip, 0.0, 1.0);
}
