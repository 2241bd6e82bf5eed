// How many steps rays took to the ground or past it: linear colours between marks.
uniform vec4 marks[4];  // r, g, b and the steps of that colour

out vec4 light;

void main() {
  float steps = texelFetch(terrain_planes, ivec3(terrain_point(), 1), 0).r;
  int i = 1;
  while (i < 3 && steps > marks[i].a) ++i;
  float share = clamp((steps - marks[i - 1].a) / (marks[i].a - marks[i - 1].a), 0.0, 1.0);
  light = vec4(mix(marks[i - 1].rgb, marks[i].rgb, share), 1.0);
}
