// The faces of a highlight's region, once more.

out vec3 place_m;
out vec3 normal;
out vec2 box_place;

void main() {
  gl_Position = clip_place();
  place_m = eye_place_m();
  normal = world_normal();
  box_place = (highlight.to_box * vec4(position_m, 1.0)).xy;
}
