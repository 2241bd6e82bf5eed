// A mesh below its highlights. Compiled for its SHADING (world::BaseShading: 0 phong, 1 gouraud, 2 cartoon, 3 flat)
// and whether it SHOWS_CURVATURE as colours in its place.
uniform sampler2D ramp_image;  // in place of steps
uniform samplerBuffer faces;   // two a face: unit normal; middle, in the axes of to_eye

in vec3 place_m;
in vec3 normal;
in vec3 front_light, back_light;
in vec2 curvatures;
out vec4 light;

// Equal steps from dark to bright, whose edges are as wide as a pixel, or the middle row of a picture.
vec3 ramp(float facing) {
  if (mesh.has_ramp == 1) return texture(ramp_image, vec2(facing, 0.5)).rgb;
  float place = clamp(facing, 0.0, 1.0) * float(mesh.cartoon_steps);
  float width = max(fwidth(place), 1e-6);
  float level = 0.0;
  for (int step = 1; step < mesh.cartoon_steps; ++step) {
    level += clamp((place - float(step)) / width + 0.5, 0.0, 1.0);
  }
  return vec3(mesh.cartoon_steps > 1 ? level / float(mesh.cartoon_steps - 1) : 1.0);
}

vec3 cartoon_light(vec3 unit_normal) {
  vec3 klx = around_klx(0.0);
  for (int i = 0; i < lighting.count; ++i) {
    klx += light_klx(i, place_m) * ramp(dot(unit_normal, toward_light(i, place_m)));
  }
  return mesh.colour / pi * klx;
}

// Red where the surface is convex, blue where it is hollow, white where it is flat, green for saddles: full where
// it bends by a radius of a tenth of the mesh.
vec3 curvature_colour() {
  vec2 k = curvatures * mesh.length_of_mesh_m * 0.1;
  float mean = clamp(0.5 * (k.x + k.y), -1.0, 1.0), saddle = clamp(sqrt(max(-k.x * k.y, 0.0)), 0.0, 1.0);
  vec3 shown = mix(vec3(0.8), mean > 0.0 ? vec3(0.75, 0.02, 0.02) : vec3(0.02, 0.05, 0.8), sqrt(abs(mean)));
  return mix(shown, vec3(0.02, 0.4, 0.05), saddle);
}

void main() {
  vec3 surface, lit_m = place_m;
  float side = gl_FrontFacing ? 1.0 : -1.0;
  Material material = Material(mesh.colour, mesh.specular, mesh.shininess);
#if SHADING == 3
  lit_m = (matrices.to_eye * vec4(texelFetch(faces, 2 * gl_PrimitiveID + 1).xyz, 1.0)).xyz;
  surface = smooth_light(material, lit_m, side * mat3(matrices.to_eye) * texelFetch(faces, 2 * gl_PrimitiveID).xyz);
#elif SHADING == 2
  surface = cartoon_light(side * unit_or_zero(normal));
#elif SHADING == 1
  surface = gl_FrontFacing ? front_light : back_light;
#else
  surface = smooth_light(material, lit_m, side * unit_or_zero(normal));
#endif
  light = vec4(through_air(surface, normalize(lit_m), length(lit_m)), 1.0);
#if SHOWS_CURVATURE
  float facing = 0.35 + 0.65 * abs(dot(unit_or_zero(normal), normalize(place_m)));
  light.rgb = view.white_kcdpm2 * facing * curvature_colour();
#endif
}
