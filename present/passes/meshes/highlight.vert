// The faces of a highlight's region, once more.
uniform mat4 to_box;  // of the projector: -1 ... 1 in x and y

out vec3 place_m;
out vec3 normal;
out vec2 box_place;

void main() {
  gl_Position = clip_place();
  place_m = eye_place_m();
  normal = world_normal();
  box_place = (to_box * vec4(position_m, 1.0)).xy;
}
