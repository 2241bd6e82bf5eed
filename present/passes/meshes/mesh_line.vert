// Strokes and boxes on a mesh.
layout(location = 0) in vec3 position_m;  // relative to the mesh's middle, in its axes

void main() {
  gl_Position = matrices.to_clip * vec4(position_m, 1.0);
  gl_Position.z *= 1.002;  // before the surface that they lie on
}
