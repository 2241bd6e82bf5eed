// The mesh's back, and strips along its borders, grown by the outline's width: they show around what lies before
// them.
layout(location = 3) in vec3 outward;  // the mean normal at this place, of all vertices there; or off the border

void main() {
  vec4 place = clip_place();
  vec4 way = matrices.to_clip * vec4(outward, 0.0);
  vec2 across_px = (way.xy * place.w - place.xy * way.w) * plain.half_image_px;
  float squared = dot(across_px, across_px);
  if (squared > 0.0) place.xy += across_px * inversesqrt(squared) * plain.outline_px * place.w / plain.half_image_px;
  place.z *= 0.999;  // behind the surface itself, where that has no thickness
  gl_Position = place;
}
