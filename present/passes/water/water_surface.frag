// What of the water a pixel shows, for water.frag: drawn before its light, so that this is worked out once a pixel
// and not once for each of the small triangles and hidden waves that touch it.
in vec2 label_m;
in vec3 position_m;
in vec2 gerstner_slope;
in vec3 gerstner_gradient;
in float gerstner_loss;
in float surf_foam;
in vec2 grid_place;

layout(location = 0) out vec4 place;   // label x and z, the footprint's long side x and z, all in m
layout(location = 1) out vec4 facet;   // Gerstner waves' dh/dx, dh/dz; distance m, the footprint's short side m
layout(location = 2) out vec4 strain;  // Gerstner waves' d dx/dx, d dx/dz, d dz/dz; their loss, 0 or 1 as cells take turns, and
                                       // twice 0 ... surf_foam_steps: the coverage by foam of breakers

void main() {
  // The pixel's footprint on the labels: long in the direction of sight.
  vec2 right_m = dFdx(label_m), up_m = dFdy(label_m);
  vec2 long_m = dot(right_m, right_m) > dot(up_m, up_m) ? right_m : up_m;
  float short_m = abs(right_m.x * up_m.y - right_m.y * up_m.x) / max(length(long_m), 1e-6);
  place = vec4(label_m, long_m);
  facet = vec4(gerstner_slope, length(position_m), short_m);
  float turn = mod(floor(grid_place.x) + floor(grid_place.y), 2.0);
  float foam = 2.0 * floor(float(surf_foam_steps) * clamp(surf_foam, 0.0, 1.0) + 0.5);
  strain = vec4(gerstner_gradient, foam + turn + clamp(gerstner_loss, 0.0, 0.999));
  if (is_in_hull(position_m)) discard;
}
