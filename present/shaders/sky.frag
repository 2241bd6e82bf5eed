// The sky behind everything, with the sun's disc. Light is in kcd/m2, linear Rec.709.
uniform vec3 ray_forward;  // direction of the ray through the picture's middle
uniform vec3 ray_right;    // what a step of 1 in clip coordinates adds to it
uniform vec3 ray_up;

in vec2 clip;
out vec4 light;

// The disc at noon is brighter than a half can hold (65504), and than any picture shows.
const float brightest_kcdpm2 = 3.0e4;

void main() {
  vec3 direction = normalize(ray_forward + clip.x * ray_right + clip.y * ray_up);
  vec3 sun = min(sky_sun_disc(sky, depth_table, direction), vec3(brightest_kcdpm2));
  light = vec4(sky_radiance(sky, view_table, direction) + sun, 1.0);
}
