// The part of the sky's round map that one face of a cube shows, with the clouds on that face over the clear sky.
uniform sampler2D clouds;     // premultiplied, kcd/m2
uniform sampler2D clear_sky;  // round map, kcd/m2

layout(location = 0) out vec4 clear_light;
layout(location = 1) out vec4 cloudy_light;

void main() {
  vec3 direction = environment_direction(clip);
  float along = dot(direction, view.ray_forward);
  vec2 place = vec2(dot(direction, view.ray_right), dot(direction, view.ray_up)) / (cloudy_sky.reach * cloudy_sky.reach * max(along, 1e-3));
  // Half a thousandth of a face too far, so that no pixel lies between two.
  if (along <= 0.0 || max(abs(place.x), abs(place.y)) * cloudy_sky.reach > 1.0005) discard;
  vec4 seen = textureLod(clouds, 0.5 + 0.5 * place, 0.0);
  vec3 behind = textureLod(clear_sky, 0.5 + 0.5 * clip, 0.0).rgb;
  clear_light = vec4(behind, 1.0);
  cloudy_light = vec4(behind * (1.0 - seen.a) + seen.rgb, 1.0);
}
