// Where a mesh's vertices are. All passes over a mesh put them on the same bits, so that depths are equal.
layout(location = 0) in vec3 position_m;  // relative to the mesh's middle, in its axes
layout(location = 1) in vec3 vertex_normal;

uniform mat4 to_clip;
uniform mat4 to_eye;  // relative to the eye, in the world's axes

uniform float cut_m;  // height over the eye's below which nothing is drawn

invariant gl_Position;

vec3 eye_place_m() {
  return (to_eye * vec4(position_m, 1.0)).xyz;
}

vec4 clip_place() {
  gl_ClipDistance[0] = eye_place_m().y - cut_m;
  return to_clip * vec4(position_m, 1.0);
}

vec3 world_normal() {
  return mat3(to_eye) * vertex_normal;
}
