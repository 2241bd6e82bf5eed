// Where a mesh's vertices are. All passes over a mesh put them on the same bits, so that depths are equal.
layout(location = 0) in vec3 position_m;  // relative to the mesh's middle, in its axes
layout(location = 1) in vec3 vertex_normal;

invariant gl_Position;

vec3 eye_place_m() {
  return (matrices.to_eye * vec4(position_m, 1.0)).xyz;
}

vec4 clip_place() {
  gl_ClipDistance[0] = eye_place_m().y - matrices.cut_m;
  return matrices.to_clip * vec4(position_m, 1.0);
}

vec3 world_normal() {
  return mat3(matrices.to_eye) * vertex_normal;
}
