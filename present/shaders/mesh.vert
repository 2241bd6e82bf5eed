// A mesh below its highlights.
layout(location = 2) in vec2 vertex_curvatures;  // k_max, k_min, 1/m

uniform int shading;  // world::BaseShading
uniform vec3 colour;
uniform float specular, shininess;

out vec3 place_m;
out vec3 normal;
out vec3 vertex_light;
out vec2 curvatures;

void main() {
  gl_Position = clip_place();
  place_m = eye_place_m();
  normal = world_normal();
  curvatures = vertex_curvatures;
  vertex_light = vec3(0.0);
  if (shading == 1) {
    // Both sides of a surface are drawn, and lit: the one that the eye sees.
    vec3 seen = dot(normal, place_m) > 0.0 ? -normal : normal;
    vertex_light = smooth_light(Material(colour, specular, shininess), place_m, normalize(seen));
  }
}
