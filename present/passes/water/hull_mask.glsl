// Keeps water out of floating hulls: what of the surface lies between the underside of one and the height up to which it
// keeps water out is not drawn (HullMap of host/bodies/hull_map.h).
uniform sampler2DArray hull_maps;  // underside, rim, in m; the rim below the underside where there is no hull

// Only where all columns around are of the hull: never beside it.
bool is_in_hull(vec3 position_m) {
  vec4 place = vec4(position_m, 1.0);
  for (int i = 0; i < grid.hull_count; ++i) {
    ivec2 texel = ivec2(floor(vec2(dot(grid.hull_planes[3 * i], place), dot(grid.hull_planes[3 * i + 1], place))));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, textureSize(hull_maps, 0).xy - 1))) continue;
    float height_m = dot(grid.hull_planes[3 * i + 2], place);
    bool is_inside = true;
    for (int corner = 0; corner < 4; ++corner) {
      vec2 heights_m = texelFetch(hull_maps, ivec3(texel + ivec2(corner & 1, corner >> 1), i), 0).xy;
      is_inside = is_inside && height_m > heights_m.x && height_m < heights_m.y;
    }
    if (is_inside) return true;
  }
  return false;
}
