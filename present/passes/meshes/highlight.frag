// A highlight within its projector's box (highlights::HighlightTexture): a shape, a picture, or a picture of normals
// that is shaded in the highlight. Compiled for the TEXTURE_KIND.
const int first_image = 6, normal_image = 7;

uniform sampler2D picture;  // premultiplied

in vec3 place_m;
in vec3 normal;
in vec2 box_place;
out vec4 light;

// Normals of the picture stand on the surface, with the box's right and up.
vec3 pictured_light(vec4 texel) {
  vec3 outward = unit_or_zero(gl_FrontFacing ? normal : -normal);
  vec3 up = unit_or_zero(cross(outward, highlight.box_right)), right = cross(up, outward);
  vec3 pictured = 2.0 * texel.rgb / max(texel.a, 1e-3) - 1.0;
  vec3 shaded = unit_or_zero(pictured.x * right + pictured.y * up + max(pictured.z, 0.05) * outward);
  return smooth_light(Material(highlight.colour, 0.4, 40.0), place_m, shaded);
}

void main() {
  vec2 uv = vec2(0.5 + 0.5 * box_place.x, 0.5 - 0.5 * box_place.y);
  vec4 texel = texture(picture, uv);
  float alpha = texel.a;
  if (TEXTURE_KIND < first_image) alpha = shape_opacity(TEXTURE_KIND, box_place, highlight.softness, highlight.shape_depth);
  bool is_in_box = max(abs(box_place.x), abs(box_place.y)) <= 1.0;
  if (highlight.shows_box != 0) {
    light = vec4(highlight.box_light, 1.0) * (is_in_box || highlight.shows_box == 2 ? 0.75 : 0.0);
    return;
  }
  if (!is_in_box || alpha <= 0.0) discard;
  vec3 surface = highlight.colour * highlight.light_kcdpm2;
  if (TEXTURE_KIND == first_image) surface *= texel.rgb / alpha;
  if (TEXTURE_KIND == normal_image) surface = pictured_light(texel);
  light = vec4(through_air(surface, normalize(place_m), length(place_m)), 1.0) * alpha * highlight.opacity;
}
