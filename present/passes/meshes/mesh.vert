// A mesh below its highlights, compiled as mesh.frag is.
layout(location = 2) in vec2 vertex_curvatures;  // k_max, k_min, 1/m

out vec3 place_m;
out vec3 normal;
out vec3 front_light, back_light;  // of both sides of the surface
out vec2 curvatures;

void main() {
  gl_Position = clip_place();
  place_m = eye_place_m();
  normal = world_normal();
  curvatures = vertex_curvatures;
  front_light = vec3(0.0);
  back_light = vec3(0.0);
#if SHADING == 1
  Material material = Material(mesh.colour, mesh.specular, mesh.shininess);
  front_light = smooth_light(material, place_m, unit_or_zero(normal));
  back_light = smooth_light(material, place_m, -unit_or_zero(normal));
#endif
}
