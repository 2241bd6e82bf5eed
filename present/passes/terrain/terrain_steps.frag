// How many steps rays took to the ground or past it: linear colours between marks.

out vec4 light;

void main() {
  float steps = texelFetch(terrain_planes, ivec3(terrain_point(), 1), 0).r;
  int i = 1;
  while (i < 3 && steps > terrain_pass.step_marks[i].a) ++i;
  float share = clamp((steps - terrain_pass.step_marks[i - 1].a) / (terrain_pass.step_marks[i].a - terrain_pass.step_marks[i - 1].a), 0.0, 1.0);
  light = vec4(mix(terrain_pass.step_marks[i - 1].rgb, terrain_pass.step_marks[i].rgb, share), 1.0);
}
