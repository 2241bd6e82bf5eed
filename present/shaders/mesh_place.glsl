// Where a mesh's vertices are. All passes over a mesh put them on the same bits, so that depths are equal.
layout(location = 0) in vec3 position_m;  // relative to the mesh's middle, in its axes
layout(location = 1) in vec3 vertex_normal;

uniform mat4 to_clip;
uniform mat4 to_eye;  // relative to the eye, in the world's axes

uniform float sea_m;  // height of the level sea over the eye's

invariant gl_Position;

vec3 eye_place_m() {
  return (to_eye * vec4(position_m, 1.0)).xyz;
}

// Where only what is above the level sea is drawn, the rest is cut away.
vec4 clip_place() {
  gl_ClipDistance[0] = eye_place_m().y - sea_m;
  return to_clip * vec4(position_m, 1.0);
}

vec3 world_normal() {
  return mat3(to_eye) * vertex_normal;
}
